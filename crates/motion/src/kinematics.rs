//! Forward kinematics: the channels of one frame go in, where every joint stands comes out.

use nalgebra::{Matrix3, Vector3};

use crate::clip::Clip;
use crate::skeleton::{Axis, Channel, Joint};

const RADIANS_PER_DEGREE: f64 = core::f64::consts::PI / 180.0;

/// Where a joint stands in the world: `world = rotation * joint + position`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorldFromJoint {
    /// From the joint's axes to those of the world.
    pub rotation: Matrix3<f64>,
    /// The joint's origin in the world, in file units.
    pub position: Vector3<f64>,
}

impl Default for WorldFromJoint {
    fn default() -> Self {
        Self {
            rotation: Matrix3::identity(),
            position: Vector3::zeros(),
        }
    }
}

/// The joints of one performer in any of its frames.
///
/// For joint j with parent p: `world_from_j = world_from_p · T(t_j) · R_1 R_2 R_3`, the rotations
/// in the order of the joint's channels, t_j its OFFSET with the position channels in it.
#[derive(Clone, Debug)]
pub struct Kinematics<'a> {
    clip: &'a Clip,
    performer: usize,
    pose: Vec<WorldFromJoint>,
}

impl<'a> Kinematics<'a> {
    /// The kinematics of one performer (from 0) of `clip`.
    pub fn new(clip: &'a Clip, performer: usize) -> Self {
        let joints = clip.performers[performer].skeleton.joints.len();
        Self {
            clip,
            performer,
            pose: vec![WorldFromJoint::default(); joints],
        }
    }

    /// Joints and End Sites of the performer: the length of every pose.
    pub fn joint_count(&self) -> usize {
        self.joints().len()
    }

    /// Frames of the clip.
    pub fn frames(&self) -> usize {
        self.clip.frames
    }

    /// Fills `pose`, one entry for each joint in the skeleton's order, with frame `frame`
    /// (from 0).
    pub fn world_from_joint(&self, frame: usize, pose: &mut [WorldFromJoint]) {
        let values = self.clip.frame_values(self.performer, frame);
        for (index, joint) in self.joints().iter().enumerate() {
            let first = joint.first_channel;
            let own = &values[first..first + joint.channels.len()];
            let parent = joint
                .parent
                .map_or_else(WorldFromJoint::default, |parent| pose[parent]);
            pose[index] = placed(joint, own, &parent);
        }
    }

    /// Fills `positions`, x, y and z of one joint after the other in the skeleton's order, with
    /// the places in the world of frame `frame` (from 0), in file units.
    pub fn positions(&mut self, frame: usize, positions: &mut [f64]) {
        let mut pose = core::mem::take(&mut self.pose);
        self.world_from_joint(frame, &mut pose);
        for (place, joint) in positions.chunks_exact_mut(3).zip(&pose) {
            place.copy_from_slice(joint.position.as_slice());
        }
        self.pose = pose;
    }

    /// Fills `pose` as [`Self::world_from_joint`] does with every channel at zero: the pose that
    /// the OFFSETs alone make.
    pub fn rest(&self, pose: &mut [WorldFromJoint]) {
        for (index, joint) in self.joints().iter().enumerate() {
            let parent = joint
                .parent
                .map_or_else(WorldFromJoint::default, |parent| pose[parent]);
            pose[index] = WorldFromJoint {
                rotation: parent.rotation,
                position: parent.position + joint.offset,
            };
        }
    }

    fn joints(&self) -> &'a [Joint] {
        &self.clip.performers[self.performer].skeleton.joints
    }
}

fn placed(joint: &Joint, values: &[f64], parent: &WorldFromJoint) -> WorldFromJoint {
    let mut offset = joint.offset;
    let mut rotation = parent.rotation;
    for (channel, &value) in joint.channels.iter().zip(values) {
        match *channel {
            Channel::Position(axis) => offset[axis.index()] = value,
            Channel::AddedPosition(axis) => offset[axis.index()] += value,
            Channel::Rotation(axis) => turn(&mut rotation, axis, value),
            Channel::Other => {}
        }
    }
    WorldFromJoint {
        rotation,
        position: parent.position + parent.rotation * offset,
    }
}

/// Multiplies `rotation` from the right by a turn about one of its axes: only the two other
/// columns change.
fn turn(rotation: &mut Matrix3<f64>, axis: Axis, degrees: f64) {
    if degrees == 0.0 {
        return;
    }
    let (sine, cosine) = libm::sincos(degrees * RADIANS_PER_DEGREE);
    let (first, second) = match axis {
        Axis::X => (1, 2),
        Axis::Y => (2, 0),
        Axis::Z => (0, 1),
    };
    for row in 0..3 {
        let (a, b) = (rotation[(row, first)], rotation[(row, second)]);
        rotation[(row, first)] = a * cosine + b * sine;
        rotation[(row, second)] = b * cosine - a * sine;
    }
}
