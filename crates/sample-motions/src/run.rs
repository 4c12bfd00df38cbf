//! A run under way, 0.33 s a step: in comes a time, out comes a posture; and the middles of the flights.
//!
//! Between the steps the body flies and falls freely; on the ground a half sine of force throws it up again. So
//! the hips are lowest in mid-stance and highest in mid-flight (Cavagna 1977). A foot stands locked to the
//! ground, a swinging leg folds; pelvis and chest turn against each other, the bent arms against the legs.

use crate::arm::Arm;
use crate::body::Side;
use crate::gait_foot::{FootTrack, Phase, Rockers, Stance};
use crate::posture::{Bend, Figure, Foot, Posture};
use crate::rotation::{Rotation, about_x, about_y, about_z};
use crate::run_swing::Swing;
use crate::take::Take;
use nalgebra::Vector3;
use std::f64::consts::{FRAC_PI_2, PI};

const STEP_S: f64 = 0.33;
const STANCE_S: f64 = 0.22;
const FLIGHT_S: f64 = STEP_S - STANCE_S;
const STEP_LENGTH: f64 = 0.645;
const SPEED: f64 = STEP_LENGTH / STEP_S;
const STEPS: usize = 12;
const FIRST_STRIKE_S: f64 = 0.30;
/// Body heights per second², for an adult of 1.70 m.
const GRAVITY: f64 = 5.77;
/// The ankle that strikes is so far before the middle of the hips.
const STRIKE_AHEAD: f64 = 0.125;
/// Height of the hips at strike and take-off.
const HIP_HEIGHT: f64 = 0.541;
const SWAY: f64 = 0.008;
const FOOT_X: f64 = 0.028;
const TURN_OUT: f64 = 0.07;
const OFF_PITCH: f64 = 1.10;
const ROCKERS: Rockers = Rockers {
    strike_pitch: -0.16,
    strike_pitch_rate: 2.4,
    heel_s: 0.05,
    forefoot_s: 0.14,
    off_pitch_rate: 3.5,
};
/// The legs are furthest apart so long before a strike.
const SPLIT_LEAD_S: f64 = 0.05;
/// Links further from the pelvis follow later.
const LAG_S: f64 = 0.02;

/// The run.
pub struct Run {
    feet: [FootTrack; 2],
}

impl Run {
    pub fn new() -> Self {
        Self {
            feet: Side::BOTH.map(foot_track),
        }
    }

    fn figure(&self, time_s: f64) -> Figure {
        let split = |links: f64| split(time_s - links * LAG_S);
        let trunk = Bend {
            forward: 0.09 + 0.02 * bob(time_s),
            right: -0.03 * carries(time_s),
            turn: -0.30 * split(1.0),
        };
        let head = Bend {
            forward: -0.14 - 0.02 * bob(time_s - LAG_S),
            right: 0.02 * carries(time_s),
            turn: 0.18 * split(1.0),
        };
        Figure {
            hip_middle: hip_middle(time_s),
            world_from_pelvis: world_from_pelvis(time_s),
            trunk,
            head,
            arms: Side::BOTH.map(|side| arm(side, time_s)),
            feet: Side::BOTH.map(|side| self.foot(side, time_s)),
        }
    }

    fn foot(&self, side: Side, time_s: f64) -> Foot {
        let yaw = about_y(side.sign() * TURN_OUT);
        let place = match self.feet[side as usize].phase(time_s) {
            Phase::Stands(stance) => stance.place(time_s),
            Phase::Swings(from, to) => Swing {
                from,
                to,
                hip: &|time_s| hip(side, time_s),
            }
            .place(time_s),
        };
        Foot {
            ankle: place.ankle,
            world_from_foot: yaw * about_x(place.pitch),
            knee_towards: yaw * Vector3::z(),
            toes_up: place.toes_up,
        }
    }
}

impl Take for Run {
    /// The clip ends in the middle of a step.
    fn duration_s(&self) -> f64 {
        strike_s(STEPS) - 0.2 * STEP_S
    }

    fn posture(&self, time_s: f64) -> Posture {
        self.figure(time_s).posture()
    }

    /// The middles of the flights: the legs are furthest apart.
    fn keyposes_s(&self) -> Vec<[f64; 2]> {
        let middle_s = |step| strike_s(step) - 0.5 * FLIGHT_S;
        (0..STEPS).map(|step| [middle_s(step); 2]).collect()
    }
}

fn strike_s(step: usize) -> f64 {
    FIRST_STRIKE_S + step as f64 * STEP_S
}

/// The right foot goes first; each foot has stood before the clip and stands again after it.
fn foot_track(side: Side) -> FootTrack {
    let first = if side == Side::Right { -2 } else { -1 };
    let stances = (first..STEPS as i32 + 2).step_by(2).map(|step| {
        let strike_s = FIRST_STRIKE_S + f64::from(step) * STEP_S;
        Stance {
            strike_s,
            off_s: strike_s + STANCE_S,
            x: side.sign() * FOOT_X,
            z: SPEED * strike_s + STRIKE_AHEAD,
            off_pitch: OFF_PITCH,
            rockers: ROCKERS,
        }
    });
    FootTrack {
        stances: stances.collect(),
    }
}

fn hip_middle(time_s: f64) -> Vector3<f64> {
    Vector3::new(
        -SWAY * carries(time_s),
        HIP_HEIGHT + bounce(time_s),
        SPEED * time_s,
    )
}

/// Height over that at the strike: the acceleration is that of gravity in flight, a half sine of force more on the ground.
fn bounce(time_s: f64) -> f64 {
    let steps = (time_s - FIRST_STRIKE_S) / STEP_S;
    let since_s = (steps - libm::floor(steps)) * STEP_S;
    let take_off = 0.5 * GRAVITY * FLIGHT_S;
    let flown_s = since_s - STANCE_S;
    if flown_s > 0.0 {
        return take_off * flown_s - 0.5 * GRAVITY * flown_s * flown_s;
    }
    let angle = PI * since_s / STANCE_S;
    let force = FRAC_PI_2 * GRAVITY * STEP_S / STANCE_S;
    let thrown = force * (STANCE_S / PI) * (STANCE_S / PI) * (angle - libm::sin(angle));
    thrown - take_off * since_s - 0.5 * GRAVITY * since_s * since_s
}

fn world_from_pelvis(time_s: f64) -> Rotation {
    about_y(0.12 * split(time_s)) * about_x(0.10) * about_z(0.06 * carries(time_s))
}

fn hip(side: Side, time_s: f64) -> Vector3<f64> {
    hip_middle(time_s) + world_from_pelvis(time_s) * crate::body::hip_from_middle(side)
}

/// Half a turn a step, +1 at a time after the strikes of the right foot, −1 after those of the left.
fn wave(time_s: f64, after_s: f64) -> f64 {
    libm::cos(PI * (time_s - FIRST_STRIKE_S - after_s) / STEP_S)
}

/// +1 where the right leg is in front, −1 where the left is.
fn split(time_s: f64) -> f64 {
    wave(time_s, -SPLIT_LEAD_S)
}

/// +1 where the right leg carries, −1 where the left does.
fn carries(time_s: f64) -> f64 {
    wave(time_s, 0.5 * STANCE_S)
}

/// +1 in mid-stance, −1 in mid-flight.
fn bob(time_s: f64) -> f64 {
    let carries = carries(time_s);
    2.0 * carries * carries - 1.0
}

/// The elbows stay bent; an arm goes forward with the leg of the other side.
fn arm(side: Side, time_s: f64) -> Arm {
    let forward = |links: f64| side.sign() * split(time_s - links * LAG_S);
    let shoulder = -0.28 + 0.58 * forward(1.0);
    let elbow = 1.62 + 0.22 * forward(2.0);
    let direction = |out: f64, angle: f64| [out, -libm::cos(angle), libm::sin(angle)];
    let mut arm = Arm::pointing(
        side,
        direction(0.26, shoulder),
        direction(-0.10 - 0.14 * forward(2.0), shoulder + elbow),
    );
    arm.wrist = 0.10;
    arm
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::{BALL, BALL_FROM_ANKLE, HEEL_FROM_ANKLE};
    use crate::leg_ik::REACH;

    const FRAME_S: f64 = 1.0 / 240.0;

    fn times(run: &Run) -> impl Iterator<Item = f64> + use<> {
        (0..(run.duration_s() / FRAME_S) as usize).map(|frame| frame as f64 * FRAME_S)
    }

    #[test]
    fn the_legs_reach_and_no_foot_is_below_the_ground() {
        let run = Run::new();
        for time_s in times(&run) {
            let figure = run.figure(time_s);
            for side in Side::BOTH {
                let foot = &figure.feet[side as usize];
                let over = (foot.ankle - figure.hip(side)).norm() - REACH;
                assert!(over <= 0.0, "{side:?} by {over} at {time_s}");
                let height = |point: Vector3<f64>| (foot.ankle + foot.world_from_foot * point).y;
                assert!(
                    height(BALL_FROM_ANKLE) > BALL[1] - 1e-3,
                    "{side:?} at {time_s}"
                );
                assert!(height(HEEL_FROM_ANKLE) > -1e-3, "{side:?} at {time_s}");
            }
        }
    }

    #[test]
    fn the_body_falls_freely_between_the_steps_and_never_jumps() {
        let bend = |time_s| {
            let hips = |step: f64| bounce(time_s + step * FRAME_S);
            (hips(1.0) - 2.0 * hips(0.0) + hips(-1.0)) / (FRAME_S * FRAME_S)
        };
        for step in 0..STEPS {
            let flies_s = strike_s(step) + STANCE_S + 0.5 * FLIGHT_S;
            assert!((bend(flies_s) + GRAVITY).abs() < 1e-6);
            assert!(bend(strike_s(step) + 0.5 * STANCE_S) > GRAVITY);
        }
        let steepest = times(&Run::new()).map(|time_s| bend(time_s).abs());
        assert!(steepest.fold(0.0, f64::max) < 3.0 * GRAVITY);
    }

    #[test]
    fn for_a_while_in_each_step_no_foot_is_on_the_ground() {
        let run = Run::new();
        let flies = |time_s: &f64| {
            let stands = |side| matches!(run.feet[side as usize].phase(*time_s), Phase::Stands(_));
            !stands(Side::Left) && !stands(Side::Right)
        };
        let share = times(&run).filter(flies).count() as f64 / times(&run).count() as f64;
        assert!((0.25..0.4).contains(&share), "{share}");
    }

    #[test]
    fn feet_move_without_jumps() {
        let run = Run::new();
        for time_s in times(&run) {
            let [before, after] = [0.0, FRAME_S].map(|step| run.figure(time_s + step).feet);
            for (a, b) in before.iter().zip(&after) {
                assert!((a.ankle - b.ankle).norm() < 7.0 * FRAME_S, "at {time_s}");
            }
        }
    }
}
