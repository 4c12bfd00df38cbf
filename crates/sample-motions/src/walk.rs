//! A walk from standing, at 0.55 s a step: in comes a time, out comes a posture; and the times of the heel strikes.
//!
//! The pelvis is lowest with both feet down and sways over the foot that carries (Inman 1981); it turns
//! with the swinging leg, the chest against it, the arms against the legs.

use crate::arm::Arm;
use crate::body::Side;
use crate::gait_foot::{FootTrack, Rockers, Stance};
use crate::posture::{Bend, Figure, Foot, Posture};
use crate::quintic::{End, Quintic, minimum_jerk};
use crate::rotation::{about_x, about_y, about_z};
use crate::take::Take;
use nalgebra::Vector3;
use std::f64::consts::PI;

const STEP_S: f64 = 0.55;
const STEP_LENGTH: f64 = 0.375;
const SPEED: f64 = STEP_LENGTH / STEP_S;
const STEPS: usize = 10;
const START_S: f64 = 0.095;
const FIRST_STRIKE_S: f64 = 0.92;
const FIRST_STEP_LENGTH: f64 = 0.28;
/// Both feet stand for so long after a strike.
const DOUBLE_SUPPORT_S: f64 = 0.12;
const FOOT_X: f64 = 0.042;
const TURN_OUT: f64 = 0.10;
const OFF_PITCH: f64 = 1.02;
const ROCKERS: Rockers = Rockers {
    strike_pitch: -0.30,
    strike_pitch_rate: 1.6,
    heel_s: 0.11,
    forefoot_s: 0.30,
    off_pitch_rate: 5.5,
};
/// The pelvis is behind the ankle that strikes by this part of a step.
const STRIKE_LEAD: f64 = 0.46;
const HIP_HEIGHT: f64 = 0.5435;
const BOB: f64 = 0.0115;
const SWAY: f64 = 0.013;
/// Links further from the pelvis follow later.
const LAG_S: f64 = 0.02;

/// The walk.
pub struct Walk {
    feet: [FootTrack; 2],
    start: Quintic,
}

impl Walk {
    pub fn new() -> Self {
        let z = FIRST_STEP_LENGTH + (1.0 - STRIKE_LEAD) * STEP_LENGTH;
        let start = Quintic::new(
            START_S,
            End::at_rest(0.0),
            strike_s(1),
            End::moving(z, SPEED),
        );
        Self {
            feet: Side::BOTH.map(foot_track),
            start,
        }
    }

    fn figure(&self, time_s: f64) -> Figure {
        let swing = swing(time_s);
        let list = sway(time_s);
        let trunk = Bend {
            forward: 0.05 + 0.012 * bob(time_s - 2.0 * LAG_S),
            right: -0.05 * sway(time_s - LAG_S),
            turn: -0.19 * self::swing(time_s - 2.0 * LAG_S),
        };
        let head = Bend {
            forward: -0.03 - 0.012 * bob(time_s - 3.0 * LAG_S),
            right: 0.0,
            turn: 0.10 * self::swing(time_s - 2.0 * LAG_S),
        };
        Figure {
            hip_middle: self.hip_middle(time_s),
            world_from_pelvis: about_y(0.08 * swing) * about_x(0.04) * about_z(0.045 * list),
            trunk,
            head,
            arms: Side::BOTH.map(|side| arm(side, time_s)),
            feet: Side::BOTH.map(|side| self.foot(side, time_s)),
        }
    }

    fn hip_middle(&self, time_s: f64) -> Vector3<f64> {
        let z = if time_s < START_S {
            0.0
        } else if time_s < strike_s(1) {
            self.start.at(time_s)
        } else {
            self.start.at(strike_s(1)) + SPEED * (time_s - strike_s(1))
        };
        let standing = (1.0 - effort(time_s)) * 0.0095;
        let height = HIP_HEIGHT + BOB * bob(time_s) + standing;
        Vector3::new(-SWAY * sway(time_s), height, z)
    }

    fn foot(&self, side: Side, time_s: f64) -> Foot {
        let place = self.feet[side as usize].place(time_s);
        let yaw = about_y(side.sign() * TURN_OUT);
        Foot {
            ankle: place.ankle,
            world_from_foot: yaw * about_x(place.pitch),
            knee_towards: yaw * Vector3::z(),
            toes_up: place.toes_up,
        }
    }
}

impl Take for Walk {
    /// The clip ends in the middle of a step.
    fn duration_s(&self) -> f64 {
        strike_s(STEPS) - 0.4 * STEP_S
    }

    fn posture(&self, time_s: f64) -> Posture {
        self.figure(time_s).posture()
    }

    /// The heel strikes.
    fn keyposes_s(&self) -> Vec<[f64; 2]> {
        (0..STEPS).map(|step| [strike_s(step); 2]).collect()
    }
}

fn strike_s(step: usize) -> f64 {
    FIRST_STRIKE_S + step as f64 * STEP_S
}

/// The right foot goes first.
fn foot_track(side: Side) -> FootTrack {
    let x = side.sign() * FOOT_X;
    let first = if side == Side::Right { 0 } else { 1 };
    let off_s = if first == 0 {
        FIRST_STRIKE_S - 0.43
    } else {
        strike_s(0) + DOUBLE_SUPPORT_S
    };
    let off_pitch = if first == 0 {
        0.7 * OFF_PITCH
    } else {
        OFF_PITCH
    };
    let mut stances = vec![Stance {
        strike_s: -9.0,
        off_s,
        x,
        z: 0.0,
        off_pitch,
        rockers: ROCKERS,
    }];
    stances.extend((first..STEPS + 2).step_by(2).map(|step| Stance {
        strike_s: strike_s(step),
        off_s: strike_s(step + 1) + DOUBLE_SUPPORT_S,
        x,
        z: FIRST_STEP_LENGTH + step as f64 * STEP_LENGTH,
        off_pitch: OFF_PITCH,
        rockers: ROCKERS,
    }));
    FootTrack { stances }
}

/// From 0 at rest to 1 in full walk.
fn effort(time_s: f64) -> f64 {
    minimum_jerk((time_s - START_S) / (FIRST_STRIKE_S + 0.2 - START_S))
}

/// Half a turn a step, 0 at the first strike.
fn phase(time_s: f64) -> f64 {
    PI * (time_s - FIRST_STRIKE_S) / STEP_S
}

/// +1 where the right leg is in front, −1 where the left is.
fn swing(time_s: f64) -> f64 {
    effort(time_s) * libm::cos(phase(time_s))
}

/// +1 where the right leg carries, −1 where the left does.
fn sway(time_s: f64) -> f64 {
    effort(time_s) * libm::sin(phase(time_s - 0.03))
}

/// −1 with both feet down, +1 over the leg that carries.
fn bob(time_s: f64) -> f64 {
    -effort(time_s) * libm::cos(2.0 * phase(time_s - 0.035))
}

fn arm(side: Side, time_s: f64) -> Arm {
    let forward = |lag_s: f64| side.sign() * swing(time_s - lag_s);
    let shoulder = 0.02 + 0.36 * forward(2.0 * LAG_S);
    let elbow = 0.34 + 0.22 * forward(4.0 * LAG_S);
    let out = 0.15;
    let direction = |out: f64, angle: f64| [out, -libm::cos(angle), libm::sin(angle)];
    let mut arm = Arm::pointing(
        side,
        direction(out, shoulder),
        direction(0.3 * out, shoulder + elbow),
    );
    arm.wrist = 0.12;
    arm
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::leg_ik::REACH;

    #[test]
    fn the_legs_reach_the_ground() {
        let walk = Walk::new();
        for frame in 0..(walk.duration_s() * 120.0) as usize {
            let figure = walk.figure(frame as f64 / 120.0);
            for side in Side::BOTH {
                let length = (figure.feet[side as usize].ankle - figure.hip(side)).norm();
                assert!(
                    length <= REACH,
                    "{side:?} by {} at frame {frame}",
                    length - REACH
                );
            }
        }
    }

    #[test]
    fn the_body_moves_without_jumps() {
        let walk = Walk::new();
        let hips = |frame: i32| walk.figure(f64::from(frame) / 120.0).hip_middle;
        for frame in 1..700 {
            let bend = hips(frame + 1) - 2.0 * hips(frame) + hips(frame - 1);
            assert!(bend.norm() * 120.0 * 120.0 < 4.0, "frame {frame}");
        }
    }
}
