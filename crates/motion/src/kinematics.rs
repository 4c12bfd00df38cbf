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
    /// The channels of the joints to place that move anything, in the order of the file.
    moves: Vec<Move>,
    /// The joints to place, and the end of each one's part of `moves`.
    placed: Vec<(usize, usize)>,
    pose: Vec<WorldFromJoint>,
}

/// What the value of one column does.
#[derive(Clone, Copy, Debug)]
struct Move {
    column: usize,
    channel: Channel,
}

impl<'a> Kinematics<'a> {
    /// The kinematics of one performer (from 0) of `clip`.
    pub fn new(clip: &'a Clip, performer: usize) -> Self {
        let joints = clip.performers[performer].skeleton.joints.len();
        let mut kinematics = Self {
            clip,
            performer,
            moves: Vec::new(),
            placed: Vec::with_capacity(joints),
            pose: vec![WorldFromJoint::default(); joints],
        };
        kinematics.place(|_| true, |_| true);
        kinematics
    }

    /// The same for some joints and those above them alone: in the poses of
    /// [`Self::world_from_joint`] `positions` and `rotations` are right, all else is not.
    #[must_use]
    pub fn only(mut self, positions: &[usize], rotations: &[usize]) -> Self {
        let all = self.joints();
        let mut is_needed = vec![false; all.len()];
        let mut turns = vec![false; all.len()];
        for joint in rotations {
            turns[*joint] = true;
        }
        for joint in positions.iter().chain(rotations) {
            is_needed[*joint] = true;
        }
        for index in (1..all.len()).rev() {
            if let Some(parent) = all[index].parent.filter(|_| is_needed[index]) {
                is_needed[parent] = true;
                turns[parent] = true;
            }
        }
        self.place(|joint| is_needed[joint], |joint| turns[joint]);
        self
    }

    /// Places the joints that `is_needed`, and turns those that `turns`.
    fn place(&mut self, is_needed: impl Fn(usize) -> bool, turns: impl Fn(usize) -> bool) {
        self.moves.clear();
        self.placed.clear();
        for (index, joint) in self.joints().iter().enumerate() {
            if !is_needed(index) {
                continue;
            }
            let columns = joint.first_channel..;
            let channels = columns.zip(joint.channels.iter().copied());
            let channels = channels.filter(|(_, channel)| match channel {
                Channel::Position(_) | Channel::AddedPosition(_) => true,
                Channel::Rotation(_) => turns(index),
                Channel::Other => false,
            });
            let moves = channels.map(|(column, channel)| Move { column, channel });
            self.moves.extend(moves);
            self.placed.push((index, self.moves.len()));
        }
    }

    /// Joints and End Sites of the performer: the length of every pose.
    pub fn joint_count(&self) -> usize {
        self.pose.len()
    }

    /// Frames of the clip.
    pub fn frames(&self) -> usize {
        self.clip.frames
    }

    /// Fills `pose`, one entry for each joint in the skeleton's order, with frame `frame`
    /// (from 0).
    pub fn world_from_joint(&self, frame: usize, pose: &mut [WorldFromJoint]) {
        let values = self.clip.frame_values(self.performer, frame);
        let mut first = 0;
        let joints = self.joints();
        for &(index, end) in &self.placed {
            pose[index] = self.moved(&joints[index], first..end, values, pose);
            first = end;
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

    /// Fills `pose` with the pose that the OFFSETs alone make, every rotation being zero.
    pub fn rest(&self, pose: &mut [WorldFromJoint]) {
        for (index, joint) in self.joints().iter().enumerate() {
            pose[index] = self.moved(joint, 0..0, &[], pose);
        }
    }

    fn joints(&self) -> &'a [Joint] {
        &self.clip.performers[self.performer].skeleton.joints
    }

    fn moved(
        &self,
        joint: &Joint,
        moves: core::ops::Range<usize>,
        values: &[f64],
        pose: &[WorldFromJoint],
    ) -> WorldFromJoint {
        let parent = joint
            .parent
            .map_or_else(WorldFromJoint::default, |parent| pose[parent]);
        let mut offset = joint.offset;
        let mut rotation = parent.rotation;
        for step in &self.moves[moves] {
            let value = values[step.column];
            match step.channel {
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
}

/// Multiplies `rotation` from the right by a turn about one of its axes: only the two other
/// columns change.
#[inline]
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

#[cfg(test)]
mod tests {
    use nalgebra::{Isometry3, Rotation3, Translation3, UnitQuaternion};

    use super::*;
    use crate::bvh;

    const FILE: &str = "HIERARCHY
ROOT Hips { OFFSET 0 1 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Spine { OFFSET 1 10 2
    CHANNELS 4 Yrotation Xscale Xposition Zrotation
    JOINT Head { OFFSET 0 5 0.5 CHANNELS 3 Xrotation Yrotation Zrotation
      End Site { OFFSET 1 2 3 } } }
  JOINT Leg { OFFSET 3 -1 0 CHANNELS 1 Xrotation
    End Site { OFFSET 0 -9 1 } } }
MOTION
Frames: 2
Frame Time: 0.04
0 0 0 0 0 0 0 0 1 0 0 0 0 0
7 8 9 10.5 -20 30 40 99 3 -50 60 170.25 -80 90
";

    fn rotation(axis: Vector3<f64>, degrees: f64) -> Isometry3<f64> {
        let turn = Rotation3::new(axis * degrees.to_radians());
        Isometry3::from_parts(Translation3::identity(), UnitQuaternion::from(turn))
    }

    /// Frame 1 of `FILE`, written out with nalgebra's own transformations.
    fn expected() -> Vec<Isometry3<f64>> {
        let (x, y, z) = (Vector3::x(), Vector3::y(), Vector3::z());
        let at = Isometry3::translation;
        let hips = at(7.0, 8.0, 9.0) * rotation(z, 10.5) * rotation(x, -20.0) * rotation(y, 30.0);
        let spine = hips * at(3.0, 10.0, 2.0) * rotation(y, 40.0) * rotation(z, -50.0);
        let turn = rotation(x, 60.0) * rotation(y, 170.25) * rotation(z, -80.0);
        let head = spine * at(0.0, 5.0, 0.5) * turn;
        let leg = hips * at(3.0, -1.0, 0.0) * rotation(x, 90.0);
        let tip = head * at(1.0, 2.0, 3.0);
        vec![hips, spine, head, tip, leg, leg * at(0.0, -9.0, 1.0)]
    }

    #[test]
    fn joints_stand_where_the_product_of_all_transformations_puts_them() {
        let clip = bvh::parse(FILE.as_bytes()).expect("a clip");
        let kinematics = Kinematics::new(&clip, 0);
        let mut pose = vec![WorldFromJoint::default(); kinematics.joint_count()];
        kinematics.world_from_joint(1, &mut pose);
        for (found, expected) in pose.iter().zip(expected()) {
            let turn = expected.rotation.to_rotation_matrix().into_inner();
            assert!((found.rotation - turn).norm() < 1e-14);
            assert!((found.position - expected.translation.vector).norm() < 1e-13);
        }
    }

    #[test]
    fn positions_are_those_of_the_poses() {
        let clip = bvh::parse(FILE.as_bytes()).expect("a clip");
        let mut kinematics = Kinematics::new(&clip, 0);
        let mut positions = [0.0; 18];
        kinematics.positions(1, &mut positions);
        let expected: Vec<_> = expected()
            .iter()
            .flat_map(|joint| joint.translation.vector.data.0[0])
            .collect();
        let largest = positions
            .iter()
            .zip(&expected)
            .map(|(a, b)| (a - b).abs())
            .fold(0.0, f64::max);
        assert!(largest < 1e-13, "{largest}");
    }

    #[test]
    fn without_rotations_the_offsets_add_up() {
        let clip = bvh::parse(FILE.as_bytes()).expect("a clip");
        let kinematics = Kinematics::new(&clip, 0);
        let mut pose = vec![WorldFromJoint::default(); kinematics.joint_count()];
        kinematics.rest(&mut pose);
        assert_eq!(pose[3].position, Vector3::new(2.0, 18.0, 5.5));
        kinematics.world_from_joint(0, &mut pose);
        assert_eq!(pose[3].position, Vector3::new(2.0, 17.0, 5.5));
        assert_eq!(pose[3].rotation, Matrix3::identity());
    }

    #[test]
    fn some_joints_alone_stand_where_they_do_among_all() {
        let clip = bvh::parse(FILE.as_bytes()).expect("a clip");
        let all = Kinematics::new(&clip, 0);
        let mut expected = vec![WorldFromJoint::default(); all.joint_count()];
        all.world_from_joint(1, &mut expected);
        let mut pose = vec![WorldFromJoint::default(); all.joint_count()];
        all.only(&[3], &[4]).world_from_joint(1, &mut pose);
        assert_eq!(pose[3].position, expected[3].position);
        assert_eq!(pose[4], expected[4]);
        assert_eq!(pose[5], WorldFromJoint::default());
    }
}
