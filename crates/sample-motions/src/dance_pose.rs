//! In: a pose as a choreographer would say it. Out: a figure standing in the world.

use crate::arm::Arm;
use crate::body::{ANKLE, BALL_FROM_ANKLE, SHIN, Side, THIGH};
use crate::leg_ik;
use crate::posture::{Bend, Figure, Foot};
use crate::rotation::{Rotation, about_x, about_y};
use nalgebra::Vector3;

/// Directions are (out, up, forward) in the thorax.
#[derive(Clone, Copy, Debug)]
pub struct ArmPose {
    pub upper: [f64; 3],
    pub fore: [f64; 3],
    pub supination_deg: f64,
    pub wrist_deg: f64,
}

/// A foot on the ground: where the ankle is while the foot is flat, its turn to the left, how far the heel is lifted about the ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stand {
    pub x: f64,
    pub z: f64,
    pub turn_deg: f64,
    pub heel_deg: f64,
}

impl Stand {
    /// Whether the ball of the foot is in the same place.
    pub fn same_place(&self, other: &Self) -> bool {
        (self.x, self.z, self.turn_deg) == (other.x, other.z, other.turn_deg)
    }

    pub fn foot(&self) -> Foot {
        let heel = self.heel_deg.to_radians();
        let yaw = about_y(self.turn_deg.to_radians());
        let world_from_foot = yaw * about_x(heel);
        let flat = Vector3::new(self.x, ANKLE[1], self.z);
        let ankle = flat + yaw * BALL_FROM_ANKLE - world_from_foot * BALL_FROM_ANKLE;
        Foot {
            ankle,
            world_from_foot,
            knee_towards: yaw * Vector3::z(),
            toes_up: heel,
        }
    }
}

/// A leg; directions are (out, up, forward) in the pelvis.
#[derive(Clone, Copy, Debug)]
pub enum LegPose {
    On(Stand),
    /// From the hip to the ankle in a direction, over a share of the leg's length; where the knee
    /// shows; how far the foot is pointed.
    Free {
        towards: [f64; 3],
        share: f64,
        knee: [f64; 3],
        point_deg: f64,
    },
}

impl LegPose {
    pub fn stand(&self) -> Option<Stand> {
        match self {
            Self::On(stand) => Some(*stand),
            Self::Free { .. } => None,
        }
    }
}

/// A pose. Bends are (forward, to the right, turn to the left) in degrees.
#[derive(Clone, Copy, Debug)]
pub struct Pose {
    /// The leg that carries, on the ground, and the share of its length that it has.
    pub weight: Side,
    pub extension: f64,
    /// The middle of the hips on the ground: x, z.
    pub over: [f64; 2],
    pub pelvis_deg: [f64; 3],
    pub trunk_deg: [f64; 3],
    pub head_deg: [f64; 3],
    pub arms: [ArmPose; 2],
    pub legs: [LegPose; 2],
}

impl Pose {
    pub fn figure(&self) -> Figure {
        let world_from_pelvis = Bend::degrees(self.pelvis_deg).rotation(1.0);
        let arms = Side::BOTH.map(|side| arm(side, &self.arms[side as usize]));
        let nowhere = Stand {
            x: 0.0,
            z: 0.0,
            turn_deg: 0.0,
            heel_deg: 0.0,
        }
        .foot();
        let mut figure = Figure {
            hip_middle: Vector3::new(self.over[0], 0.0, self.over[1]),
            world_from_pelvis,
            trunk: Bend::degrees(self.trunk_deg),
            head: Bend::degrees(self.head_deg),
            arms,
            feet: [nowhere; 2],
        };
        if let LegPose::On(stand) = self.legs[self.weight as usize] {
            let length = self.extension * (THIGH + SHIN);
            figure.hip_middle.y = hip_height(&figure, self.weight, &stand.foot().ankle, length);
        }
        figure.feet = Side::BOTH.map(|side| foot(&figure, side, &self.legs[side as usize]));
        figure
    }
}

fn arm(side: Side, pose: &ArmPose) -> Arm {
    let mut arm = Arm::pointing(side, pose.upper, pose.fore);
    arm.supination = pose.supination_deg.to_radians();
    arm.wrist = pose.wrist_deg.to_radians();
    arm
}

/// The height of the middle of the hips at which a leg has a length; as low as its ankle if it is too far.
pub fn hip_height(figure: &Figure, side: Side, ankle: &Vector3<f64>, length: f64) -> f64 {
    let from_hip = ankle - figure.hip(side);
    let across = from_hip.x * from_hip.x + from_hip.z * from_hip.z;
    figure.hip_middle.y + from_hip.y + (length * length - across).max(0.0).sqrt()
}

fn foot(figure: &Figure, side: Side, leg: &LegPose) -> Foot {
    match *leg {
        LegPose::On(stand) => stand.foot(),
        LegPose::Free {
            towards,
            share,
            knee,
            point_deg,
        } => {
            let in_world = |v| figure.world_from_pelvis * side.mirror(v).normalize();
            let hip = figure.hip(side);
            let ankle = hip + in_world(towards) * (share * (THIGH + SHIN));
            let knee_towards = in_world(knee);
            let leg = leg_ik::solve(&hip, &ankle, &knee_towards);
            let point: Rotation = about_x(point_deg.to_radians());
            let world_from_foot = leg.world_from_shin * point;
            Foot {
                ankle,
                world_from_foot,
                knee_towards,
                toes_up: -0.2,
            }
        }
    }
}

/// The ball of a foot in the world.
#[cfg(test)]
pub fn ball(foot: &Foot) -> Vector3<f64> {
    foot.ankle + foot.world_from_foot * BALL_FROM_ANKLE
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::BALL;

    #[test]
    fn a_lifted_heel_leaves_the_ball_in_place() {
        let stand = |heel_deg| Stand {
            x: 0.1,
            z: -0.2,
            turn_deg: 25.0,
            heel_deg,
        };
        let (flat, lifted) = (stand(0.0).foot(), stand(50.0).foot());
        assert!((ball(&flat) - ball(&lifted)).norm() < 1e-12);
        assert!((ball(&flat).y - BALL[1]).abs() < 1e-12);
        assert!(lifted.ankle.y > flat.ankle.y + 0.03);
        assert!(stand(0.0).same_place(&stand(50.0)));
    }
}
