//! A dance from pose to pose: in comes a time, out comes a posture; and the times of the holds.

use crate::dance_move::{Key, LAST_LAG_S, Move};
use crate::dance_steps::{Beat, SLOW};
use crate::posture::{Figure, Posture};

/// In this share of a move no part goes further than 1 % of its way: it belongs to the hold beside it.
const STILL: f64 = 0.1;

/// The poses with their times.
pub struct Dance {
    keys: Vec<Key>,
}

impl Dance {
    pub fn slow() -> Self {
        let mut time_s = 0.0;
        let mut key = |beat: &Beat| {
            let arrive_s = time_s + beat.move_s;
            time_s = arrive_s + beat.hold_s;
            let stands = beat.pose.legs.map(|leg| leg.stand());
            Key {
                figure: beat.pose.figure(),
                stands,
                arrive_s,
                leave_s: time_s,
                dip: beat.dip,
            }
        };
        Self {
            keys: SLOW.iter().map(&mut key).collect(),
        }
    }

    pub fn duration_s(&self) -> f64 {
        self.keys[self.keys.len() - 1].leave_s
    }

    /// The holds: no part is further from the pose than 1 % of its way. The two ends of the clip are none.
    pub fn holds_s(&self) -> Vec<[f64; 2]> {
        self.keys
            .windows(3)
            .map(|keys| hold_s(&keys[0], &keys[1], &keys[2]))
            .collect()
    }

    pub fn posture(&self, time_s: f64) -> Posture {
        self.figure(time_s).posture()
    }

    fn figure(&self, time_s: f64) -> Figure {
        let last = self.keys.len() - 2;
        let left = self.keys.iter().filter(|key| key.leave_s <= time_s).count();
        let from = left.saturating_sub(1).min(last);
        Move {
            from: &self.keys[from],
            to: &self.keys[from + 1],
            time_s,
        }
        .figure()
    }
}

fn hold_s(before: &Key, key: &Key, after: &Key) -> [f64; 2] {
    let coming_s = key.arrive_s - before.leave_s;
    let going_s = after.arrive_s - key.leave_s;
    [
        key.arrive_s + LAST_LAG_S - STILL * coming_s,
        key.leave_s + STILL * going_s,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::{BALL, Side};
    use crate::dance_pose::ball;
    use crate::leg_ik::REACH;

    const FRAME_S: f64 = 1.0 / 120.0;

    fn frames(dance: &Dance) -> impl Iterator<Item = f64> + use<> {
        let count = (dance.duration_s() / FRAME_S) as usize;
        (0..count).map(|frame| frame as f64 * FRAME_S)
    }

    #[test]
    fn a_foot_that_stays_does_not_slide() {
        let dance = Dance::slow();
        for pair in dance.keys.windows(2) {
            for (n, foot) in pair[0].figure.feet.iter().enumerate() {
                let [a, b] = [pair[0].stands[n], pair[1].stands[n]];
                if !matches!((a, b), (Some(a), Some(b)) if a.same_place(&b)) {
                    continue;
                }
                for step in 0..=20 {
                    let share = f64::from(step) / 20.0;
                    let time_s = pair[0].leave_s + share * (pair[1].leave_s - pair[0].leave_s);
                    let moved = ball(&dance.figure(time_s - 1e-9).feet[n]) - ball(foot);
                    assert!(moved.norm() < 1e-9, "{moved:?} at {time_s} s");
                }
            }
        }
    }

    #[test]
    fn legs_that_stand_reach_and_no_foot_is_below_the_ground() {
        let dance = Dance::slow();
        for time_s in frames(&dance) {
            let figure = dance.figure(time_s);
            for side in Side::BOTH {
                let foot = &figure.feet[side as usize];
                let length = (foot.ankle - figure.hip(side)).norm();
                assert!(
                    length <= REACH + 1e-3,
                    "{side:?} {} at {time_s}",
                    length / REACH
                );
                assert!(
                    ball(foot).y > BALL[1] - 0.004,
                    "{side:?} {:?} at {time_s}",
                    ball(foot)
                );
            }
        }
    }

    #[test]
    fn the_body_moves_without_jumps() {
        let dance = Dance::slow();
        let hips = |time_s| dance.figure(time_s).hip_middle;
        for time_s in frames(&dance).skip(1) {
            let bend = hips(time_s + FRAME_S) - 2.0 * hips(time_s) + hips(time_s - FRAME_S);
            assert!(
                bend.norm() < 12.0 * FRAME_S * FRAME_S,
                "{} at {time_s} s",
                bend.norm()
            );
        }
    }
}
