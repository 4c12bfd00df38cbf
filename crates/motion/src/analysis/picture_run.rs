//! How one performer is pictured, some frames at a step: its keyposes go in; the frame of the
//! thumbnail, the side from which the figures are widest and what they look like come out.

use super::pose_run::Posed;
use crate::clip::Clip;
use crate::figure::{FarthestPose, WidestSide};
use crate::kinematics::{Kinematics, WorldFromJoint};
use crate::posture::{Pose, PostureWord, posture};

/// Frames looked at in one step.
const FRAMES_A_STEP: usize = 1 << 8;

/// What the pictures are taken of.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    pub thumbnail_frame: usize,
    pub side_yaw_rad: f64,
    /// Of each keypose; empty where the body is not human or has no left and right.
    pub postures: Vec<Vec<PostureWord>>,
}

/// Looks for the thumbnail among the keyposes, without any among all frames; then at the figures
/// from all sides.
#[derive(Clone, Debug)]
pub struct PictureRun {
    /// Frames of the file; none: all analysed frames.
    keyposes: Vec<usize>,
    farthest: FarthestPose,
    side: WidestSide,
    postures: Vec<Vec<PostureWord>>,
    /// Frames looked at for the thumbnail, then for the side.
    done: [usize; 2],
}

impl PictureRun {
    /// Makes ready for a performer with these keyposes (frames of the file).
    pub fn new(posed: Posed<'_>, keyposes: Vec<usize>) -> Self {
        Self {
            keyposes,
            farthest: FarthestPose::default(),
            side: WidestSide::new(posed.surroundings.up.0),
            postures: Vec::new(),
            done: [0; 2],
        }
    }

    /// Looks at some frames more. Returns the picture, once it is there.
    pub fn step(&mut self, clip: &Clip, performer: usize, posed: Posed<'_>) -> Option<Picture> {
        let track = &posed.followed.track;
        let frames = match self.keyposes.len() {
            0 => track.frames(),
            count => count,
        };
        if self.done[0] < frames {
            self.look_for_thumbnail(posed, frames);
            return None;
        }
        let thumbnail_frame = self.farthest.frame().unwrap_or(0);
        // Without a keypose the thumbnail is the one figure.
        let figures = match self.keyposes.as_slice() {
            [] => vec![thumbnail_frame],
            _ => self.next_keyposes(),
        };
        self.look_at_figures(clip, performer, &figures);
        self.look_at_postures(clip, performer, posed);
        self.done[1] += figures.len();
        (self.done[1] >= self.keyposes.len()).then(|| Picture {
            thumbnail_frame,
            side_yaw_rad: self.side.yaw_rad(),
            postures: core::mem::take(&mut self.postures),
        })
    }

    fn next_keyposes(&self) -> Vec<usize> {
        let next = self.keyposes.iter().skip(self.done[1]);
        next.take(FRAMES_A_STEP).copied().collect()
    }

    fn look_for_thumbnail(&mut self, posed: Posed<'_>, frames: usize) {
        let (track, mean) = (&posed.followed.track, &posed.followed.mean);
        let end = frames.min(self.done[0] + 16 * FRAMES_A_STEP);
        for index in self.done[0]..end {
            let frame = match self.keyposes.get(index) {
                Some(keypose) => *keypose,
                None => track.first_frame + index,
            };
            let coordinates = track.frame(frame - track.first_frame);
            self.farthest.add(frame, coordinates, mean);
        }
        self.done[0] = end;
    }

    fn look_at_figures(&mut self, clip: &Clip, performer: usize, figures: &[usize]) {
        let mut kinematics = Kinematics::new(clip, performer);
        let mut pose = vec![0.0; 3 * kinematics.joint_count()];
        for &frame in figures.iter().filter(|frame| **frame < clip.frames) {
            kinematics.positions(frame, &mut pose);
            self.side.add(&pose);
        }
    }

    fn look_at_postures(&mut self, clip: &Clip, performer: usize, posed: Posed<'_>) {
        let (frame, around) = (&posed.placement.frame, posed.surroundings);
        let kinematics = Kinematics::new(clip, performer);
        let mut world_from_joint = vec![WorldFromJoint::default(); kinematics.joint_count()];
        for keypose in self.next_keyposes() {
            kinematics.world_from_joint(keypose, &mut world_from_joint);
            let (up, ground_height) = (around.up.0, around.ground_height);
            let pose = Pose::new(posed.body, frame, &world_from_joint, up, ground_height);
            self.postures.extend(pose.map(|pose| posture(&pose)));
        }
    }
}
