//! The analysis of all performers of a clip, in steps.

use super::performer::PerformerRun;
use super::settings::{Decisions, Settings, SettingsError, Source};
use super::survey::Survey;
use super::{Analysis, PerformerAnalysis};
use crate::clip::Clip;
use crate::keypose::Options;
use crate::note::NoteKind;
use crate::track::PelvisTrack;

/// Analyses a clip in steps of a few milliseconds.
#[derive(Clone, Debug, Default)]
pub struct Analyser {
    settings: Option<Settings>,
    frame_time_s: f64,
    frame_time_source: Option<Source>,
    runs: Vec<PerformerRun>,
    /// What was said to be done last: a piece that is made twice does not turn it back.
    done: f64,
    /// The same of the survey.
    surveyed: f64,
}

impl Analyser {
    /// An analyser that knows nothing yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Makes ready for settings; what was made with others and does not depend on the difference
    /// stays. Always with the same clip.
    ///
    /// # Errors
    /// A decision or an option that cannot be.
    pub fn begin(
        &mut self,
        clip: &Clip,
        decisions: &Decisions,
        options: &Options,
    ) -> Result<(), SettingsError> {
        decisions.validate()?;
        decisions.validate_joints(clip)?;
        options.validate()?;
        let user_s = decisions.frame_rate_hz.map(|hz| 1.0 / hz);
        let next = Settings {
            decisions: decisions.clone(),
            options: *options,
            frame_rate_hz: decisions
                .frame_rate_hz
                .unwrap_or_else(|| clip.frame_rate_hz()),
        };
        self.frame_time_s = user_s.unwrap_or(clip.frame_time_s);
        self.frame_time_source = Some(match user_s {
            Some(_) => Source::User,
            None => found_or_default(clip),
        });
        self.runs
            .resize_with(clip.performers.len(), PerformerRun::default);
        if let Some(last) = self.settings.replace(next.clone()) {
            for (performer, run) in self.runs.iter_mut().enumerate() {
                run.change(performer, &last, &next);
            }
        }
        self.done = 0.0;
        self.surveyed = 0.0;
        Ok(())
    }

    /// A few milliseconds of work. Returns the part done; 1 when the analysis is there.
    pub fn step(&mut self, clip: &Clip) -> f64 {
        let Some(settings) = &self.settings else {
            return 0.0;
        };
        let count = self.runs.len().max(1) as f64;
        let next = self.runs.iter().position(|run| run.analysis().is_none());
        let Some(performer) = next else {
            return 1.0;
        };
        // Options are checked when work begins.
        let done = self.runs[performer].step(clip, performer, settings);
        let whole = (performer as f64 + done.unwrap_or(1.0)) / count;
        self.done = self.done.max(whole);
        self.done
    }

    /// A few milliseconds of work towards the survey alone; a later [`Analyser::step`] goes on from
    /// there. Returns the part done; 1 when the survey and the tracks are there.
    pub fn step_survey(&mut self, clip: &Clip) -> f64 {
        let Some(settings) = &self.settings else {
            return 0.0;
        };
        let Some(performer) = self.runs.iter().position(|run| run.track().is_none()) else {
            return 1.0;
        };
        let done = self.runs[performer].step_poses(clip, performer, settings);
        // Below 1: only the look above says that nothing is missing.
        let whole = (performer as f64 + done.min(0.99)) / self.runs.len() as f64;
        self.surveyed = self.surveyed.max(whole);
        self.surveyed
    }

    /// The survey, once [`Analyser::step_survey`] has said 1; before that, of the performers done.
    pub fn survey(&self) -> Survey {
        let of = |run: &PerformerRun| run.survey(self.settings.as_ref()?);
        Survey {
            frame_time_s: self.frame_time_s,
            frame_time_source: self.frame_time_source.unwrap_or(Source::Found),
            performers: self.runs.iter().map_while(of).collect(),
        }
    }

    /// The analysed frames of a performer (from 0) in pelvis coordinates; none where the poses are
    /// not made yet or were dropped.
    pub fn track(&self, performer: usize) -> Option<&PelvisTrack> {
        self.runs.get(performer)?.track()
    }

    /// The analysis, once [`Analyser::step`] has said 1; before that, of the performers done.
    pub fn analysis(&self) -> Analysis {
        let performers = self.runs.iter().map_while(PerformerRun::analysis);
        let settings = self.settings.as_ref();
        Analysis {
            options: settings.map_or_else(Options::default, |settings| settings.options),
            frame_time_s: self.frame_time_s,
            frame_time_source: self.frame_time_source.unwrap_or(Source::Found),
            performers: performers.cloned().collect::<Vec<PerformerAnalysis>>(),
        }
    }

    /// Frees the poses; results stay.
    pub fn drop_motion(&mut self) {
        self.runs.iter_mut().for_each(PerformerRun::drop_motion);
    }

    /// Bytes that the poses take.
    pub fn motion_bytes(&self) -> usize {
        self.runs.iter().map(PerformerRun::motion_bytes).sum()
    }
}

/// Whether the file says its frame time, as far as the notes tell.
fn found_or_default(clip: &Clip) -> Source {
    let assumed = [NoteKind::FrameTimeMissing, NoteKind::FrameTimeInvalid];
    match clip.notes.iter().any(|note| assumed.contains(&note.kind)) {
        true => Source::Default,
        false => Source::Found,
    }
}
