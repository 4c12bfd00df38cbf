//! What a performer's pieces come to: the pieces go in, the analysis with its notes comes out.

use super::keypose_run::Extracted;
use super::picture_run::Picture;
use super::pose_run::Posed;
use super::settings::Settings;
use super::survey::PerformerSurvey;
use super::{KeyposeAnalysis, PerformerAnalysis};
use crate::clip::Clip;
use crate::note::{Note, NoteKind};

/// The finished pieces of one performer; keyposes are none where frames are too few.
#[derive(Clone, Copy, Debug)]
pub struct Findings<'a> {
    pub clip: &'a Clip,
    pub settings: &'a Settings,
    pub posed: Posed<'a>,
    pub keyposes: Option<Extracted<'a>>,
    pub picture: &'a Picture,
}

impl Findings<'_> {
    /// All of it as one analysis.
    pub fn analysis(&self) -> PerformerAnalysis {
        PerformerAnalysis {
            survey: PerformerSurvey::new(self.posed, &self.settings.decisions),
            keyposes: self.keyposes(),
            keypose_notes: self.keypose_notes(),
            thumbnail_frame: self.picture.thumbnail_frame,
            side_yaw_rad: self.picture.side_yaw_rad,
            trail_joints: self.trail_joints(),
        }
    }

    fn keyposes(&self) -> Result<KeyposeAnalysis, Note> {
        let track = &self.posed.followed.track;
        match self.keyposes {
            Some(found) => Ok(KeyposeAnalysis {
                first_frame: track.first_frame,
                speed: found.speed.values.clone(),
                trend: found.trend.to_vec(),
                extraction: found.extraction.clone(),
                part_changes: found.part_changes.to_vec(),
                postures: self.picture.postures.clone(),
            }),
            None if self.clip.frames == 0 => Err(Note::new(NoteKind::NoMotion, Vec::new())),
            None => {
                let frames = track.frames().to_string();
                Err(Note::new(NoteKind::TooShort, vec![frames]))
            }
        }
    }

    fn trail_joints(&self) -> Vec<usize> {
        let Posed { body, followed, .. } = self.posed;
        match body.is_human() {
            true => followed.trails.joints(body),
            false => Vec::new(),
        }
    }

    /// What the frame rate did not allow.
    fn keypose_notes(&self) -> Vec<Note> {
        let mut notes = Vec::new();
        let Some(found) = self.keyposes else {
            return notes;
        };
        if !found.speed.filtered {
            let cutoff = self.settings.options.low_pass_hz.to_string();
            notes.push(Note::new(NoteKind::LowPassLeftOut, vec![cutoff]));
        }
        if found.extraction.scales_left_out > 0 {
            let finest = found.extraction.scales_hz.first();
            let details = finest.map(|hz| format!("{hz:.2}")).into_iter().collect();
            notes.push(Note::new(NoteKind::ScalesLeftOut, details));
        }
        notes
    }
}
