//! One pass through the motion: what all later stages need of the poses, stored frame by frame.

use nalgebra::{Matrix3, Vector3};

use super::{Body, PelvisFrame, Role, TrackRun};
use crate::clip::Clip;
use crate::kinematics::{Kinematics, WorldFromJoint};
use crate::track::PelvisTrack;

/// Coordinates of a point.
const AXES: usize = 3;

/// The poses of one performer, in file units.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PoseTable {
    /// Joints of each frame: 16, or all in a body that is not human.
    pub joint_count: usize,
    /// Frames × joints × (x, y, z): q_n(j) of the method, from the pelvis joint and in its axes.
    pub joints: Vec<f64>,
    /// Frames × (left, right) × (x, y, z): q_n of the hips; empty in a body that is not human.
    pub hips: Vec<f64>,
    /// How the body stands in the world.
    pub footing: Footing,
}

/// What tells up and the ground, from all frames, in file units.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Footing {
    /// The sum over the frames of neck − middle of the ankles, in world axes.
    pub trunk: Vector3<f64>,
    /// For each frame the lowest x, y, z and the highest x, y, z of ankles and toes (of all joints
    /// in a body that is not human), in the world.
    pub feet: Vec<[f64; 6]>,
}

impl PoseTable {
    /// Frames in the table.
    pub fn frames(&self) -> usize {
        self.footing.feet.len()
    }

    /// The place of a joint (its row, from 0) at a frame, in the pelvis joint's axes.
    pub fn joint(&self, frame: usize, row: usize) -> Vector3<f64> {
        point(&self.joints, frame * self.joint_count + row)
    }

    /// The middle of the hips at a frame, in the pelvis joint's axes.
    pub fn hip_middle(&self, frame: usize) -> Vector3<f64> {
        (self.hip(frame, 0) + self.hip(frame, 1)) / 2.0
    }

    /// The left (0) or right (1) hip at a frame, in the pelvis joint's axes.
    pub fn hip(&self, frame: usize, side: usize) -> Vector3<f64> {
        point(&self.hips, 2 * frame + side)
    }

    /// The first `frames` frames in the coordinates of `frame`.
    pub fn first_track(&self, frame: &PelvisFrame, frames: usize) -> PelvisTrack {
        let values = frames.min(self.frames()) * self.joint_count * AXES;
        let mut coordinates = self.joints[..values].to_vec();
        frame.apply(&mut coordinates);
        PelvisTrack {
            coordinates,
            joint_count: self.joint_count,
            first_frame: 0,
        }
    }

    /// The frames from `first_frame` on in the coordinates of `frame`; the table's memory is used
    /// again.
    pub fn into_track(mut self, frame: &PelvisFrame, first_frame: usize) -> PelvisTrack {
        let mut run = TrackRun::new(&mut self, frame, first_frame);
        run.advance(usize::MAX);
        run.finish()
    }
}

fn point(values: &[f64], index: usize) -> Vector3<f64> {
    Vector3::from_column_slice(&values[AXES * index..AXES * index + AXES])
}

/// Fills a [`PoseTable`] in steps, so that other work can go on between them.
#[derive(Clone, Debug)]
pub struct TableBuilder<'a> {
    kinematics: Kinematics<'a>,
    pose: Vec<WorldFromJoint>,
    reference: usize,
    joints: Vec<usize>,
    hips: Vec<usize>,
    feet: Vec<usize>,
    trunk: Option<[usize; 3]>,
    table: PoseTable,
}

impl<'a> TableBuilder<'a> {
    /// A builder for one performer (from 0) and its body.
    pub fn new(clip: &'a Clip, performer: usize, body: &Body) -> Self {
        Self::from_reference(clip, performer, body, body.pelvis)
    }

    /// A builder whose coordinates are those of the root joint.
    pub fn in_root(clip: &'a Clip, performer: usize, body: &Body) -> Self {
        Self::from_reference(clip, performer, body, 0)
    }

    fn from_reference(clip: &'a Clip, performer: usize, body: &Body, reference: usize) -> Self {
        const FEET: [Role; 4] = [
            Role::LeftAnkle,
            Role::LeftToe,
            Role::RightAnkle,
            Role::RightToe,
        ];
        let joints = body.analysed(clip, performer);
        let is_human = body.is_human();
        let of = |roles: &[Role]| roles.iter().filter_map(|role| body.joint(*role)).collect();
        let trunk: Vec<usize> = of(&[Role::Neck, Role::LeftAnkle, Role::RightAnkle]);
        let hips = if is_human {
            body.hips.to_vec()
        } else {
            Vec::new()
        };
        let needed = [joints.as_slice(), &hips].concat();
        let kinematics = Kinematics::new(clip, performer).only(&needed, &[reference]);
        Self {
            pose: vec![WorldFromJoint::default(); kinematics.joint_count()],
            kinematics,
            reference,
            hips,
            feet: if is_human { of(&FEET) } else { joints.clone() },
            trunk: <[usize; 3]>::try_from(trunk).ok().filter(|_| is_human),
            table: PoseTable {
                joint_count: joints.len(),
                ..PoseTable::default()
            },
            joints,
        }
    }

    /// The same builder with the frames that an earlier one has put into `table`.
    #[must_use]
    pub fn resume(mut self, table: PoseTable) -> Self {
        if table.joint_count == self.table.joint_count {
            self.table = table;
        }
        self
    }

    /// Frames not yet in the table.
    pub fn frames_left(&self) -> usize {
        self.kinematics.frames() - self.table.frames()
    }

    /// Adds at most `frames` frames; says whether the table is complete.
    pub fn step(&mut self, frames: usize) -> bool {
        let first = self.table.frames();
        let last = first + frames.min(self.frames_left());
        self.reserve(last - first);
        for frame in first..last {
            self.kinematics.world_from_joint(frame, &mut self.pose);
            self.add();
        }
        self.frames_left() == 0
    }

    /// The table of the frames added.
    pub fn finish(self) -> PoseTable {
        self.table
    }

    /// A table of one frame, the pose of the OFFSETs, for a clip without motion.
    pub fn rest(mut self) -> PoseTable {
        self.kinematics.rest(&mut self.pose);
        self.add();
        self.table
    }

    /// Room for the whole clip at once where the rest is asked for, so that no copy is made.
    fn reserve(&mut self, frames: usize) {
        let frames = if self.table.footing.feet.is_empty() {
            self.kinematics.frames()
        } else {
            frames
        };
        self.table.joints.reserve(frames * self.joints.len() * AXES);
        self.table.hips.reserve(frames * self.hips.len() * AXES);
        self.table.footing.feet.reserve(frames);
    }

    fn add(&mut self) {
        let reference = self.pose[self.reference];
        for joint in &self.joints {
            let from = self.pose[*joint].position - reference.position;
            self.table
                .joints
                .extend(unturned(&reference.rotation, &from));
        }
        for joint in &self.hips {
            let from = self.pose[*joint].position - reference.position;
            self.table.hips.extend(unturned(&reference.rotation, &from));
        }
        if let Some([neck, left, right]) = self
            .trunk
            .map(|joints| joints.map(|joint| self.pose[joint].position))
        {
            self.table.footing.trunk += neck - (left + right) / 2.0;
        }
        let feet = self.feet.iter().map(|joint| self.pose[*joint].position);
        self.table.footing.feet.push(extent(feet));
    }
}

/// The transposed rotation times the vector, in written order.
fn unturned(rotation: &Matrix3<f64>, vector: &Vector3<f64>) -> [f64; AXES] {
    [0, 1, 2].map(|column| {
        rotation[(0, column)] * vector.x
            + rotation[(1, column)] * vector.y
            + rotation[(2, column)] * vector.z
    })
}

/// The lowest x, y, z and the highest x, y, z.
fn extent(points: impl Iterator<Item = Vector3<f64>>) -> [f64; 6] {
    let mut extent = [
        f64::INFINITY,
        f64::INFINITY,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NEG_INFINITY,
        f64::NEG_INFINITY,
    ];
    for point in points {
        for axis in 0..AXES {
            extent[axis] = extent[axis].min(point[axis]);
            extent[axis + AXES] = extent[axis + AXES].max(point[axis]);
        }
    }
    extent
}
