//! A dance from pose to pose: in comes a time, out comes a posture; and the times of the holds.

use crate::dance_move::{Key, LAST_LAG_S, Move};
use crate::dance_steps::{Beat, SLOW};
use crate::dance_tired::{tired, tremble};
use crate::posture::{Figure, Posture};
use crate::take::Take;

/// In this share of a move no part goes further than 1 % of its way: it belongs to the hold beside it.
const STILL: f64 = 0.1;

/// The poses with their times.
pub struct Dance {
    keys: Vec<Key>,
    trembles: bool,
}

impl Dance {
    pub fn slow() -> Self {
        Self {
            keys: keys(&SLOW),
            trembles: false,
        }
    }

    /// The same dance by someone who is tired.
    pub fn tired() -> Self {
        Self {
            keys: keys(&SLOW.map(|beat| tired(&beat))),
            trembles: true,
        }
    }

    fn figure(&self, time_s: f64) -> Figure {
        let last = self.keys.len() - 2;
        let left = self.keys.iter().filter(|key| key.leave_s <= time_s).count();
        let from = left.saturating_sub(1).min(last);
        let way = Move {
            from: &self.keys[from],
            to: &self.keys[from + 1],
            time_s,
        };
        let mut figure = way.carried();
        if self.trembles {
            tremble(&mut figure, time_s);
        }
        way.stand(&mut figure);
        figure
    }
}

impl Take for Dance {
    fn duration_s(&self) -> f64 {
        self.keys[self.keys.len() - 1].leave_s
    }

    fn posture(&self, time_s: f64) -> Posture {
        self.figure(time_s).posture()
    }

    /// The holds: no part is further from the pose than 1 % of its way. The two ends of the clip are none.
    fn keyposes_s(&self) -> Vec<[f64; 2]> {
        self.keys
            .windows(3)
            .map(|keys| hold_s(&keys[0], &keys[1], &keys[2]))
            .collect()
    }
}

fn keys(beats: &[Beat]) -> Vec<Key> {
    let mut time_s = 0.0;
    let key = |beat: &Beat| {
        let arrive_s = time_s + beat.move_s;
        time_s = arrive_s + beat.hold_s;
        Key {
            figure: beat.pose.figure(),
            stands: beat.pose.legs.map(|leg| leg.stand()),
            arrive_s,
            leave_s: time_s,
            dip: beat.dip,
        }
    };
    beats.iter().map(key).collect()
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

    fn both() -> [Dance; 2] {
        [Dance::slow(), Dance::tired()]
    }

    #[test]
    fn a_foot_that_stays_does_not_slide() {
        both().iter().for_each(assert_no_foot_slides);
    }

    fn assert_no_foot_slides(dance: &Dance) {
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
        both().iter().for_each(assert_feet_are_on_the_ground);
    }

    fn assert_feet_are_on_the_ground(dance: &Dance) {
        for time_s in frames(dance) {
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
        both().iter().for_each(assert_no_jumps);
    }

    fn assert_no_jumps(dance: &Dance) {
        let hips = |time_s| dance.figure(time_s).hip_middle;
        for time_s in frames(dance).skip(1) {
            let bend = hips(time_s + FRAME_S) - 2.0 * hips(time_s) + hips(time_s - FRAME_S);
            assert!(
                bend.norm() < 12.0 * FRAME_S * FRAME_S,
                "{} at {time_s} s",
                bend.norm()
            );
        }
    }

    #[test]
    fn holds_last_from_a_fifth_to_two_fifths_of_a_second() {
        for [from_s, to_s] in both().iter().flat_map(Take::keyposes_s) {
            assert!((0.2..=0.4).contains(&(to_s - from_s)), "{from_s} to {to_s}");
        }
    }
}
