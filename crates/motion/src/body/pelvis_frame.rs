//! The pelvis frame and the body height: axes and origin constant in the pelvis joint.

use nalgebra::{Matrix3, Vector3};

use super::rest_pose::RestPose;
use super::table::PoseTable;
use super::tree::Tree;
use super::{Body, Role};
use crate::clip::Clip;
use crate::note::{Note, NoteKind};

/// Hips nearer to each other than this (in leg lengths) lie together in the OFFSETs.
const HIPS_TOGETHER: f64 = 0.06;

/// Hips nearer to each other than this (in leg lengths) make no left and right.
const NO_SIDES: f64 = 5e-4;

/// The cosine between trunk and legs below which the rest pose is a body.
const REST_IS_BODY: f64 = -0.5;

/// Body height over trunk and leg length: about the size of "pelvis to head tip plus legs".
const HEIGHT_PER_TRUNK_AND_LEG: f64 = 1.2;

/// The part of the trunk across the hips is shorter than this (in leg lengths): no direction.
const NO_TRUNK: f64 = 0.1;

/// The cosine of the angle between rest trunk and mean trunk below which the rest is unusable.
const TRUNK_AGREES: f64 = 0.5;

/// Where the pelvis coordinates lie: `axes · (q − origin) / height`, q in the pelvis joint's axes.
#[derive(Clone, Debug, PartialEq)]
pub struct PelvisFrame {
    /// The joint in whose axes the frame is constant.
    pub pelvis: usize,
    /// Rows x (from the right hip to the left), y (along the trunk), z (forward), in the axes of
    /// the pelvis joint.
    pub axes: Matrix3<f64>,
    /// The middle of the hips from the pelvis joint, in its axes, in file units.
    pub origin: Vector3<f64>,
    /// The body height in file units; in a body that is not human the longest way from the root to
    /// a joint.
    pub height: f64,
    /// Whether these are root coordinates, for want of a left and right.
    pub is_root: bool,
    /// What was assumed.
    pub notes: Vec<Note>,
}

/// What the steps share.
struct Measures<'a> {
    tree: Tree<'a>,
    body: &'a Body,
    table: &'a PoseTable,
    first_frame: usize,
    leg: f64,
    hips: [Vector3<f64>; 2],
}

impl PelvisFrame {
    /// The frame of one performer (from 0) over the frames of `table` from `first_frame` on.
    pub fn new(
        clip: &Clip,
        performer: usize,
        body: &Body,
        table: &PoseTable,
        first_frame: usize,
    ) -> Self {
        let skeleton = &clip.performers[performer].skeleton;
        let rest = RestPose::new(clip, performer, first_frame, 1);
        if !body.is_human() {
            return Self::of_root(positive(rest.size), Vec::new());
        }
        let mut notes = Vec::new();
        let measures = Measures::new(
            Tree::new(skeleton, rest),
            body,
            table,
            first_frame,
            &mut notes,
        );
        let height = measures.height(&mut notes);
        match measures.axes(&mut notes) {
            Some(axes) => Self {
                pelvis: body.pelvis,
                axes,
                origin: measures.hip_middle(),
                height,
                is_root: false,
                notes,
            },
            None => {
                notes.push(Note::new(NoteKind::NoLeftAndRight, Vec::new()));
                Self::of_root(height, notes)
            }
        }
    }

    fn of_root(height: f64, notes: Vec<Note>) -> Self {
        Self {
            pelvis: 0,
            axes: Matrix3::identity(),
            origin: Vector3::zeros(),
            height,
            is_root: true,
            notes,
        }
    }

    /// Turns points (x, y, z after each other) from the pelvis joint's axes into this frame.
    pub fn apply(&self, points: &mut [f64]) {
        let axes = &self.axes;
        for point in points.chunks_exact_mut(3) {
            let from = [0, 1, 2].map(|axis| point[axis] - self.origin[axis]);
            for (row, value) in point.iter_mut().enumerate() {
                let along =
                    axes[(row, 0)] * from[0] + axes[(row, 1)] * from[1] + axes[(row, 2)] * from[2];
                *value = along / self.height;
            }
        }
    }
}

/// A length that can be divided by.
fn positive(length: f64) -> f64 {
    if length > 0.0 && length.is_finite() {
        length
    } else {
        1.0
    }
}

impl<'a> Measures<'a> {
    /// Step 1: leg length and hips.
    fn new(
        tree: Tree<'a>,
        body: &'a Body,
        table: &'a PoseTable,
        first_frame: usize,
        notes: &mut Vec<Note>,
    ) -> Self {
        let ankle = |role: Role| body.joint(role).unwrap_or(0);
        let left = tree.path_length(body.hips[0], ankle(Role::LeftAnkle));
        let right = tree.path_length(body.hips[1], ankle(Role::RightAnkle));
        let mut measures = Self {
            hips: [Vector3::zeros(); 2],
            leg: (left + right) / 2.0,
            tree,
            body,
            table,
            first_frame,
        };
        measures.hips = body.hips.map(|hip| measures.rest(hip));
        if measures.hip_distance() < HIPS_TOGETHER * measures.leg {
            let means = [0, 1].map(|side| measures.mean(|frame| table.hip(frame, side)));
            if let [Some(left), Some(right)] = means {
                measures.hips = [left, right];
                notes.push(Note::new(NoteKind::HipsTogether, Vec::new()));
            }
        }
        measures
    }

    /// r(j): from the pelvis joint to `joint` along the OFFSETs.
    fn rest(&self, joint: usize) -> Vector3<f64> {
        self.tree.place(joint) - self.tree.place(self.body.pelvis)
    }

    fn rest_of(&self, role: Role) -> Vector3<f64> {
        self.rest(self.body.joint(role).unwrap_or(self.body.pelvis))
    }

    fn rest_middle(&self, one: Role, other: Role) -> Vector3<f64> {
        (self.rest_of(one) + self.rest_of(other)) / 2.0
    }

    fn hip_middle(&self) -> Vector3<f64> {
        (self.hips[0] + self.hips[1]) / 2.0
    }

    fn hip_distance(&self) -> f64 {
        (self.hips[0] - self.hips[1]).norm()
    }

    fn frames(&self) -> core::ops::Range<usize> {
        self.first_frame.min(self.table.frames())..self.table.frames()
    }

    /// The mean over the analysed frames; none without frames.
    fn mean(&self, of: impl Fn(usize) -> Vector3<f64>) -> Option<Vector3<f64>> {
        let frames = self.frames();
        let count = frames.len();
        let sum = frames
            .map(of)
            .fold(Vector3::zeros(), |sum, value| sum + value);
        (count > 0).then(|| sum / count as f64)
    }

    /// Step 2: whether the all-zero pose is a body.
    fn rest_is_body(&self) -> bool {
        let up = self.rest_of(Role::Neck) - self.hip_middle();
        let down = self.rest_middle(Role::LeftAnkle, Role::RightAnkle) - self.hip_middle();
        let across = self.rest_of(Role::LeftShoulder) - self.rest_of(Role::RightShoulder);
        up.dot(&down) <= REST_IS_BODY * (up.norm() * down.norm())
            && across.dot(&(self.hips[0] - self.hips[1])) > 0.0
    }

    /// Step 3: the body height.
    fn height(&self, notes: &mut Vec<Note>) -> f64 {
        let shoulders = self.rest_middle(Role::LeftShoulder, Role::RightShoulder);
        let mut trunk = (shoulders - self.hip_middle()).norm();
        if !self.rest_is_body() {
            if let Some(median) = self.median_trunk() {
                trunk = median;
            }
            notes.push(Note::new(NoteKind::RestIsNoBody, Vec::new()));
        }
        positive(HEIGHT_PER_TRUNK_AND_LEG * (trunk + self.leg))
    }

    fn median_trunk(&self) -> Option<f64> {
        let (left, right) = (Role::LeftShoulder.index(), Role::RightShoulder.index());
        let length = |frame: usize| {
            let shoulders = (self.table.joint(frame, left) + self.table.joint(frame, right)) / 2.0;
            (shoulders - self.table.hip_middle(frame)).norm()
        };
        let mut lengths: Vec<f64> = self.frames().map(length).collect();
        lengths.sort_by(f64::total_cmp);
        let middle = lengths.len() / 2;
        match lengths.len() % 2 {
            0 if lengths.is_empty() => None,
            0 => Some((lengths[middle - 1] + lengths[middle]) / 2.0),
            _ => Some(lengths[middle]),
        }
    }

    /// Steps 4 to 7: the axes; none if there is no left and right, or no trunk.
    fn axes(&self, notes: &mut Vec<Note>) -> Option<Matrix3<f64>> {
        if self.hip_distance() < NO_SIDES * self.leg || self.hip_distance() == 0.0 {
            return None;
        }
        let x = (self.hips[0] - self.hips[1]) / self.hip_distance();
        let across = |vector: Vector3<f64>| vector - x * x.dot(&vector);
        let rest = across(self.rest_of(Role::Neck) - self.hip_middle());
        let neck = Role::Neck.index();
        let mean = self.mean(|frame| self.table.joint(frame, neck) - self.table.hip_middle(frame));
        let mean = mean.unwrap_or(rest);
        let too_short =
            |vector: &Vector3<f64>| vector.norm() < NO_TRUNK * self.leg || vector.norm() == 0.0;
        let agrees = rest.dot(&mean) >= TRUNK_AGREES * rest.norm() * mean.norm();
        let mut trunk = rest;
        if too_short(&rest) || !agrees {
            trunk = across(mean);
            if too_short(&trunk) {
                return None;
            }
            notes.push(Note::new(NoteKind::TrunkFromMotion, Vec::new()));
        }
        let y = trunk / trunk.norm();
        let z = x.cross(&y);
        Some(Matrix3::from_rows(&[
            x.transpose(),
            y.transpose(),
            z.transpose(),
        ]))
    }
}
