//! What a performer's pieces come to: the pieces go in, the analysis with its pictures and notes
//! comes out.

use super::performer::Settings;
use super::placement::Placement;
use super::trails::Trails;
use super::{KeyposeAnalysis, PerformerAnalysis};
use crate::body::Body;
use crate::clip::Clip;
use crate::figure;
use crate::keypose::Extraction;
use crate::kinematics::{Kinematics, WorldFromJoint};
use crate::note::{Note, NoteKind};
use crate::part_change::PartChange;
use crate::posture::{Pose, PostureWord, posture};
use crate::speed::MotionSpeed;
use crate::track::PelvisTrack;

/// The finished pieces of one performer; speed and extraction are none where frames are too few.
#[derive(Clone, Copy, Debug)]
pub struct Findings<'a> {
    pub clip: &'a Clip,
    pub performer: usize,
    pub settings: &'a Settings,
    pub body: &'a Body,
    pub placement: &'a Placement,
    pub track: &'a PelvisTrack,
    pub jumps: &'a [Note],
    pub feature: Option<[f64; 12]>,
    pub trails: Trails,
    pub speed: Option<&'a MotionSpeed>,
    pub trend: &'a [f64],
    pub extraction: Option<&'a Extraction>,
    pub part_changes: &'a [PartChange],
}

impl Findings<'_> {
    /// All of it as one analysis.
    pub fn analysis(&self) -> PerformerAnalysis {
        let placement = self.placement;
        let keyposes = self.keyposes();
        let mut frames = keyposes
            .as_ref()
            .map(KeyposeAnalysis::keyposes)
            .unwrap_or_default();
        let thumbnail_frame = figure::thumbnail_frame(self.track, &frames).unwrap_or(0);
        if frames.is_empty() {
            frames.push(thumbnail_frame);
        }
        let unit = placement.unit(self.body, &self.settings.decisions);
        PerformerAnalysis {
            body: self.body.clone(),
            height: placement.frame.height,
            up: placement.up,
            ground_height: placement.ground_height,
            unit,
            leading_rest: placement.leading_rest,
            keyposes,
            feature: self.feature,
            thumbnail_frame,
            side_yaw_rad: self.side_yaw_rad(&frames),
            front_yaw_rad: placement.front_yaw_rad,
            trail_joints: self.trail_joints(),
            notes: self.notes(unit.is_none()),
        }
    }

    fn keyposes(&self) -> Result<KeyposeAnalysis, Note> {
        match (self.speed, self.extraction) {
            (Some(speed), Some(extraction)) => Ok(KeyposeAnalysis {
                first_frame: self.track.first_frame,
                speed: speed.values.clone(),
                trend: self.trend.to_vec(),
                extraction: extraction.clone(),
                part_changes: self.part_changes.to_vec(),
                postures: self.postures(extraction),
            }),
            _ if self.clip.frames == 0 => Err(Note::new(NoteKind::NoMotion, Vec::new())),
            _ => {
                let frames = self.track.frames().to_string();
                Err(Note::new(NoteKind::TooShort, vec![frames]))
            }
        }
    }

    fn postures(&self, extraction: &Extraction) -> Vec<Vec<PostureWord>> {
        let Placement {
            frame,
            up,
            ground_height,
            ..
        } = self.placement;
        let kinematics = Kinematics::new(self.clip, self.performer);
        let mut world_from_joint = vec![WorldFromJoint::default(); kinematics.joint_count()];
        let words = |keypose: usize| -> Option<Vec<PostureWord>> {
            let row = self.track.first_frame + keypose;
            kinematics.world_from_joint(row, &mut world_from_joint);
            let pose = Pose::new(self.body, frame, &world_from_joint, up.0, *ground_height)?;
            Some(posture(&pose))
        };
        extraction.keyposes().into_iter().map_while(words).collect()
    }

    fn trail_joints(&self) -> Vec<usize> {
        match self.body.is_human() {
            true => self.trails.joints(self.body),
            false => Vec::new(),
        }
    }

    fn notes(&self, is_unit_unknown: bool) -> Vec<Note> {
        let mut notes = self.body.notes.clone();
        notes.extend(self.placement.notes());
        if is_unit_unknown {
            notes.push(Note::new(NoteKind::UnitUnknown, Vec::new()));
        }
        notes.extend_from_slice(self.jumps);
        if self.speed.is_some_and(|speed| !speed.filtered) {
            let cutoff = self.settings.options.low_pass_hz.to_string();
            notes.push(Note::new(NoteKind::LowPassLeftOut, vec![cutoff]));
        }
        if let Some(extraction) = self.extraction.filter(|one| one.scales_left_out > 0) {
            let finest = extraction.scales_hz.first().map(|hz| format!("{hz:.2}"));
            let details = finest.into_iter().collect();
            notes.push(Note::new(NoteKind::ScalesLeftOut, details));
        }
        notes
    }

    /// The yaw from which the poses at `frames` are widest.
    fn side_yaw_rad(&self, frames: &[usize]) -> f64 {
        let mut kinematics = Kinematics::new(self.clip, self.performer);
        let width = 3 * kinematics.joint_count();
        let mut poses = Vec::new();
        for &frame in frames.iter().filter(|frame| **frame < self.clip.frames) {
            let mut pose = vec![0.0; width];
            kinematics.positions(frame, &mut pose);
            poses.push(pose);
        }
        let poses: Vec<&[f64]> = poses.iter().map(Vec::as_slice).collect();
        figure::widest_side_yaw(&poses, self.placement.up.0)
    }
}
