//! One performer's analysis as a row of pieces, each made from those before it. A step makes a part
//! of the first piece that is missing; a changed setting takes away what depends on it.

use super::PerformerAnalysis;
use super::findings::Findings;
use super::keypose_run::KeyposeRun;
use super::picture_run::{Picture, PictureRun};
use super::pose_run::{PoseRun, Posed};
use super::settings::Settings;
use super::survey::PerformerSurvey;
use crate::clip::Clip;
use crate::keypose::OptionsError;
use crate::track::PelvisTrack;

/// With fewer analysed frames the speed has no inner value.
const FEWEST_FRAMES: usize = 4;

/// The part of the whole that is done when the poses are, and when the keyposes are.
const POSED: f64 = 0.3;
const EXTRACTED: f64 = 0.98;

/// The pieces of one performer, in the order in which they are made.
#[derive(Clone, Debug, Default)]
pub struct PerformerRun {
    poses: PoseRun,
    keyposes: KeyposeRun,
    picture_run: Option<PictureRun>,
    picture: Option<Picture>,
    analysis: Option<PerformerAnalysis>,
}

impl PerformerRun {
    /// Takes away what `next` makes invalid for this performer (from 0).
    pub fn change(&mut self, performer: usize, last: &Settings, next: &Settings) {
        if last == next {
            return;
        }
        let joints_of = |settings: &Settings| settings.decisions.joints_of(performer);
        if joints_of(last) != joints_of(next) {
            *self = Self::default();
        }
        self.analysis = None;
        self.picture_run = None;
        self.picture = None;
        if self.poses.change(&last.decisions, &next.decisions) {
            self.keyposes.forget();
        }
        self.keyposes.change(last, next);
    }

    /// Frees the poses; they are made again when a later piece needs them.
    pub fn drop_motion(&mut self) {
        self.poses.drop_motion();
        self.keyposes.drop_motion();
        self.picture_run = None;
    }

    /// Bytes that the poses take.
    pub fn motion_bytes(&self) -> usize {
        self.poses.motion_bytes() + self.keyposes.motion_bytes()
    }

    /// The result, once [`Self::step`] has said 1.
    pub fn analysis(&self) -> Option<&PerformerAnalysis> {
        self.analysis.as_ref()
    }

    /// What is known without the keyposes, once [`Self::step_poses`] has said 1.
    pub fn survey(&self, settings: &Settings) -> Option<PerformerSurvey> {
        let posed = self.poses.posed()?;
        Some(PerformerSurvey::new(posed, &settings.decisions))
    }

    /// The analysed frames in pelvis coordinates, as long as the poses are there.
    pub fn track(&self) -> Option<&PelvisTrack> {
        Some(&self.poses.posed()?.followed.track)
    }

    /// Makes a part of the first missing pose. Returns the part done, 1 when all are there.
    pub fn step_poses(&mut self, clip: &Clip, performer: usize, settings: &Settings) -> f64 {
        match self.poses.posed() {
            Some(_) => 1.0,
            None => self.poses.step(clip, performer, &settings.decisions),
        }
    }

    /// Makes a part of the first missing piece. Returns the part done, 1 when all is there.
    ///
    /// # Errors
    /// An option that cannot be.
    pub fn step(
        &mut self,
        clip: &Clip,
        performer: usize,
        settings: &Settings,
    ) -> Result<f64, OptionsError> {
        if self.analysis.is_some() {
            return Ok(1.0);
        }
        let Some(posed) = self.poses.posed() else {
            return Ok(POSED * self.poses.step(clip, performer, &settings.decisions));
        };
        let track = &posed.followed.track;
        if track.frames() >= FEWEST_FRAMES && self.keyposes.extracted().is_none() {
            let done = self.keyposes.step(track, posed.body.is_human(), settings)?;
            return Ok(POSED + (EXTRACTED - POSED) * done);
        }
        let Some(picture) = &self.picture else {
            let keyposes = &self.keyposes;
            let mut run = self
                .picture_run
                .take()
                .unwrap_or_else(|| PictureRun::new(posed, keyposes_of(keyposes, posed)));
            self.picture = run.step(clip, performer, posed);
            self.picture_run = Some(run).filter(|_| self.picture.is_none());
            return Ok(EXTRACTED);
        };
        let findings = Findings {
            clip,
            settings,
            posed,
            keyposes: self.keyposes.extracted(),
            picture,
        };
        self.analysis = Some(findings.analysis());
        Ok(1.0)
    }
}

/// Frames of the file.
fn keyposes_of(keyposes: &KeyposeRun, posed: Posed<'_>) -> Vec<usize> {
    let first_frame = posed.followed.track.first_frame;
    let found = keyposes
        .extracted()
        .map(|found| found.extraction.keyposes());
    let in_file = |frame| first_frame + frame;
    found.unwrap_or_default().into_iter().map(in_file).collect()
}
