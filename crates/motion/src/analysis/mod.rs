//! A clip and a person's decisions in, everything that is shown of it out: body, world, speed,
//! keyposes, feature, pictures and notes.
//!
//! [`analyse`] does it at once; an [`Analyser`] does it in steps, so that other work can go on
//! between them, and after a changed setting does only the later stages again. Its survey is the part
//! that a comparison needs.

mod analyser;
mod facing;
mod findings;
mod following;
mod keypose_run;
mod performer;
mod picture_run;
mod placement;
mod pose_run;
mod settings;
mod surroundings;
mod survey;
mod trails;

pub use analyser::Analyser;
pub use settings::{Decisions, JointDecision, SettingsError, Source};
pub use survey::{PerformerSurvey, Survey};

use crate::clip::Clip;
use crate::keypose::{Extraction, Options};
use crate::note::Note;
use crate::part_change::PartChange;
use crate::posture::PostureWord;

/// What was found in one clip.
#[derive(Clone, Debug, PartialEq)]
pub struct Analysis {
    /// The parameters that it was made with.
    pub options: Options,
    /// Seconds from one frame to the next, as used.
    pub frame_time_s: f64,
    /// Where the frame time is from.
    pub frame_time_source: Source,
    /// One for each performer of the clip, in its order.
    pub performers: Vec<PerformerAnalysis>,
}

/// What was found of one performer. Frames are those of the file, from 0.
#[derive(Clone, Debug, PartialEq)]
pub struct PerformerAnalysis {
    /// What is known without keyposes: body, world, feature.
    pub survey: PerformerSurvey,
    /// Keyposes and what leads to them, or why there are none.
    pub keyposes: Result<KeyposeAnalysis, Note>,
    /// What the frame rate did not allow on the way to them.
    pub keypose_notes: Vec<Note>,
    /// The frame that pictures the motion.
    pub thumbnail_frame: usize,
    /// The yaw from which the figures of the keyposes are widest, see
    /// [`crate::figure::WidestSide`].
    pub side_yaw_rad: f64,
    /// The wrist and the ankle with the longest path in the pelvis frame, whose trails are drawn at
    /// first; empty where the body is not human.
    pub trail_joints: Vec<usize>,
}

impl PerformerAnalysis {
    /// All that was assumed and found out of the ordinary.
    pub fn notes(&self) -> impl Iterator<Item = &Note> {
        self.survey.notes.iter().chain(&self.keypose_notes)
    }
}

/// Keyposes and the series that lead to them.
#[derive(Clone, Debug, PartialEq)]
pub struct KeyposeAnalysis {
    /// The frame of the file to which the first value of `speed` belongs.
    pub first_frame: usize,
    /// Motion speed in body heights per second.
    pub speed: Vec<f64>,
    /// The slow part of it.
    pub trend: Vec<f64>,
    /// Candidates, traces, intensities and keyposes; frames count from `first_frame`.
    pub extraction: Extraction,
    /// Of each keypose, how the parts of the body move there against the time around it; empty where
    /// the body is not human.
    pub part_changes: Vec<PartChange>,
    /// Of each keypose, what it looks like; empty where the body is not human or has no left and
    /// right.
    pub postures: Vec<Vec<PostureWord>>,
}

impl KeyposeAnalysis {
    /// Frames of the file of the keyposes, ascending.
    pub fn keyposes(&self) -> Vec<usize> {
        let kept = self.extraction.selection.kept.iter();
        kept.map(|candidate| self.frame_of(*candidate)).collect()
    }

    /// The frame of the file of a candidate.
    pub fn frame_of(&self, candidate: usize) -> usize {
        self.first_frame + self.extraction.candidates[candidate]
    }

    /// The time scale, in Hz, at which a candidate is strongest; none without a trace.
    pub fn strongest_hz(&self, candidate: usize) -> Option<f64> {
        let scale = self.extraction.traces.strongest_scale(candidate)?;
        self.extraction.scales_hz.get(scale).copied()
    }
}

/// Analyses a clip at once.
///
/// # Errors
/// A decision or an option that cannot be.
pub fn analyse(
    clip: &Clip,
    decisions: &Decisions,
    options: &Options,
) -> Result<Analysis, SettingsError> {
    let mut analyser = Analyser::new();
    analyser.begin(clip, decisions, options)?;
    while analyser.step(clip) < 1.0 {}
    Ok(analyser.analysis())
}

/// Surveys a clip at once: what [`analyse`] finds, short of the keyposes.
///
/// # Errors
/// A decision that cannot be.
pub fn survey(clip: &Clip, decisions: &Decisions) -> Result<Survey, SettingsError> {
    let mut analyser = Analyser::new();
    analyser.begin(clip, decisions, &Options::default())?;
    while analyser.step_survey(clip) < 1.0 {}
    Ok(analyser.survey())
}
