//! One pose, as the words ask for it: places and directions of the joints of a human body.

use nalgebra::Vector3;

use crate::body::{Body, PelvisFrame, Role, Side};
use crate::kinematics::WorldFromJoint;
use crate::world::Up;

/// Where a human body's joints stand at one frame, in the world and in body heights.
#[derive(Clone, Debug, PartialEq)]
pub struct Pose {
    pub(super) places: Vec<Vector3<f64>>,
    /// Towards the sky.
    pub up: Vector3<f64>,
    /// The height of the ground along `up`.
    pub ground: f64,
    /// From the right hip to the left.
    pub pelvis_left: Vector3<f64>,
}

impl Pose {
    /// The pose `world_from_joint` of a body; none if it is not human or has no left and right.
    pub fn new(
        body: &Body,
        frame: &PelvisFrame,
        world_from_joint: &[WorldFromJoint],
        up: Up,
        ground_height: f64,
    ) -> Option<Self> {
        if !body.is_human() || frame.is_root {
            return None;
        }
        let place = |role: &Role| {
            let joint = body.joint(*role)?;
            Some(world_from_joint.get(joint)?.position / frame.height)
        };
        let left = Vector3::from_iterator(frame.axes.row(0).iter().copied());
        Some(Self {
            places: Role::ALL.iter().map(place).collect::<Option<_>>()?,
            up: up.direction(),
            ground: ground_height / frame.height,
            pelvis_left: world_from_joint.get(frame.pelvis)?.rotation * left,
        })
    }

    /// Where a joint stands.
    pub fn at(&self, role: Role) -> Vector3<f64> {
        self.places[role.index()]
    }

    /// How high a joint stands above the ground.
    pub fn clearance(&self, role: Role) -> f64 {
        self.at(role).dot(&self.up) - self.ground
    }

    /// From the middle of the hips to the neck.
    pub fn trunk(&self) -> Vector3<f64> {
        let hips = (self.at(Role::LeftHip) + self.at(Role::RightHip)) / 2.0;
        self.at(Role::Neck) - hips
    }

    /// From the right shoulder to the left, of length 1.
    pub fn chest_left(&self) -> Vector3<f64> {
        unit(self.at(Role::LeftShoulder) - self.at(Role::RightShoulder))
    }

    /// Where the chest faces, of length 1.
    pub fn chest_forward(&self) -> Vector3<f64> {
        unit(self.chest_left().cross(&self.trunk()))
    }

    /// Level directions to the left of the pelvis and before it, of length 1 (0 if it lies on its
    /// side).
    pub fn level_axes(&self) -> [Vector3<f64>; 2] {
        let left = self.pelvis_left;
        let level_left = unit(left - self.up * left.dot(&self.up));
        [level_left, level_left.cross(&self.up)]
    }

    /// A limb from its first joint to its third, as a part of its length when straight.
    pub fn reach(&self, [start, middle, end, _]: [Role; 4]) -> Vector3<f64> {
        let [start, middle, end] = [start, middle, end].map(|role| self.at(role));
        let length = (middle - start).norm() + (end - middle).norm();
        match length > 0.0 {
            true => (end - start) / length,
            false => Vector3::zeros(),
        }
    }

    /// The cosine of the angle at a limb's second joint: −1 straight, 0 bent by a right angle.
    pub fn bend(&self, [start, middle, end, _]: [Role; 4]) -> f64 {
        let [start, middle, end] = [start, middle, end].map(|role| self.at(role));
        unit(start - middle).dot(&unit(end - middle))
    }

    /// Whether the body stands upright with its arms down.
    pub fn is_upright(&self) -> bool {
        const NEAR: f64 = 0.95;
        let down = |limb: [Role; 4]| -self.reach(limb).dot(&self.up);
        let are_down = |side: Side| down(Role::arm(side)) > 0.8 && down(Role::leg(side)) > 0.9;
        unit(self.trunk()).dot(&self.up) > NEAR && Side::BOTH.into_iter().all(are_down)
    }
}

/// The vector at length 1; 0 stays 0.
pub fn unit(vector: Vector3<f64>) -> Vector3<f64> {
    let length = vector.norm();
    match length > 0.0 {
        true => vector / length,
        false => vector,
    }
}
