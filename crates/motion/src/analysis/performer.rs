//! One performer's analysis as a row of pieces, each made from those before it. A step makes a part
//! of the first piece that is missing; a changed setting takes pieces away.

use super::PerformerAnalysis;
use super::findings::Findings;
use super::following::Following;
use super::placement::Placement;
use super::settings::Decisions;
use super::trails::Trails;
use crate::body::{self, BODY_PARTS, Body, PelvisFrame, PoseTable, TableBuilder};
use crate::clip::Clip;
use crate::keypose::{Extraction, Extractor, Options, OptionsError};
use crate::note::Note;
use crate::part_change::{PartChange, part_change};
use crate::speed::{self, MotionSpeed, SpeedRun};
use crate::track::PelvisTrack;

/// Joints placed in one step.
const JOINTS_A_STEP: usize = 1 << 16;

/// Frames turned into pelvis coordinates in one step.
const FRAMES_A_STEP: usize = 1 << 14;

/// Rows filtered in one step, eight columns each.
const ROWS_A_STEP: usize = 1 << 16;

/// With fewer analysed frames the speed has no inner value.
const FEWEST_FRAMES: usize = 4;

/// Parts of the whole that are done when poses, speed and extraction are.
const POSED: f64 = 0.25;
const PLACED: f64 = 0.3;
const SPEED_KNOWN: f64 = 0.6;

/// What the pieces are made with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    pub decisions: Decisions,
    pub options: Options,
    pub frame_rate_hz: f64,
}

/// The pieces of one performer, in the order in which they are made.
#[derive(Clone, Debug, Default)]
pub struct PerformerRun {
    body: Option<Body>,
    table: PoseTable,
    /// The frame, once it is known to be that of the root though the body is human.
    root_frame: Option<PelvisFrame>,
    placement: Option<Placement>,
    following: Option<Following>,
    track: Option<PelvisTrack>,
    jumps: Vec<Note>,
    feature: Option<[f64; 12]>,
    trails: Trails,
    speed_run: Option<SpeedRun>,
    speed: Option<MotionSpeed>,
    trend: Vec<f64>,
    extractor: Option<Extractor>,
    extraction: Option<Extraction>,
    part_changes: Option<Vec<PartChange>>,
    analysis: Option<PerformerAnalysis>,
}

impl PerformerRun {
    /// Takes away what `next` makes invalid.
    pub fn change(&mut self, last: &Settings, next: &Settings) {
        let (before, after) = (&last.decisions, &next.decisions);
        self.analysis = None;
        if before.leading_rest_frames != after.leading_rest_frames || before.up != after.up {
            self.drop_motion();
            self.root_frame = None;
            self.placement = None;
            self.forget_speed();
        }
        let is_same_rate = last.frame_rate_hz == next.frame_rate_hz;
        if !is_same_rate || last.options.low_pass_hz != next.options.low_pass_hz {
            self.forget_speed();
        }
        if last.options != next.options {
            self.forget_extraction();
            self.trend = Vec::new();
        }
    }

    /// Frees the poses; they are made again when a later piece needs them.
    pub fn drop_motion(&mut self) {
        self.table = PoseTable::default();
        self.following = None;
        self.track = None;
        self.speed_run = None;
        if let Some(speed) = &mut self.speed {
            speed.parts = Vec::new();
        }
    }

    /// Bytes that the poses take.
    pub fn motion_bytes(&self) -> usize {
        let track = self
            .track
            .as_ref()
            .map_or(0, |track| track.coordinates.capacity());
        let following = self.following.as_ref().map_or(0, Following::capacity);
        let parts = self
            .speed
            .as_ref()
            .map_or(0, |speed| speed.parts.capacity());
        let poses = track + following + self.table.joints.capacity();
        (poses + parts * BODY_PARTS) * size_of::<f64>()
    }

    /// The result, once [`Self::step`] has said 1.
    pub fn analysis(&self) -> Option<&PerformerAnalysis> {
        self.analysis.as_ref()
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
        let Some(body) = &self.body else {
            self.body = Some(body::find(clip, performer, &[]));
            return Ok(0.0);
        };
        if self.following.is_some() {
            let is_human = body.is_human();
            return Ok(POSED + (PLACED - POSED) * self.follow(is_human));
        }
        let Some(track) = &self.track else {
            let body = body.clone();
            return Ok(POSED * self.place(clip, performer, &body, settings));
        };
        if track.frames() >= FEWEST_FRAMES && self.speed.is_none() {
            return Ok(PLACED + (SPEED_KNOWN - PLACED) * self.measure_speed(settings));
        }
        if self.extraction.is_none() && self.speed.is_some() {
            let done = self.extract(settings)?;
            return Ok(SPEED_KNOWN + (0.99 - SPEED_KNOWN) * done);
        }
        if self.part_changes.is_none() && self.speed.is_some() {
            let is_human = body.is_human();
            self.compare_parts(is_human, settings.frame_rate_hz);
            return Ok(0.99);
        }
        self.analysis = self.finished(clip, performer, settings);
        Ok(1.0)
    }

    fn forget_speed(&mut self) {
        self.speed_run = None;
        self.speed = None;
        self.forget_extraction();
        self.trend = Vec::new();
    }

    fn forget_extraction(&mut self) {
        self.extractor = None;
        self.extraction = None;
        self.part_changes = None;
    }

    /// Adds poses to the table, or, when all are there, makes what comes of it.
    fn place(&mut self, clip: &Clip, performer: usize, body: &Body, settings: &Settings) -> f64 {
        if self.table.frames() < clip.frames {
            self.add_poses(clip, performer, body);
        } else if let Some(placement) = &self.placement {
            let table = core::mem::take(&mut self.table);
            let first_frame = placement.leading_rest.frames;
            self.following = Some(Following::new(table, &placement.frame, first_frame));
            return 1.0;
        } else {
            self.place_body(clip, performer, body, settings);
        }
        self.table.frames() as f64 / clip.frames.max(1) as f64
    }

    fn add_poses(&mut self, clip: &Clip, performer: usize, body: &Body) {
        let table = core::mem::take(&mut self.table);
        let placed = self.placement.as_ref().map(|placement| &placement.frame);
        let frame = self.root_frame.as_ref().or(placed);
        let mut builder = match frame.is_some_and(|frame| frame.is_root) {
            true => TableBuilder::in_root(clip, performer, body),
            false => TableBuilder::new(clip, performer, body),
        }
        .resume(table);
        let joints = clip.performers[performer].skeleton.joints.len();
        builder.step(JOINTS_A_STEP / joints.max(1) + 1);
        self.table = builder.finish();
    }

    fn place_body(&mut self, clip: &Clip, performer: usize, body: &Body, settings: &Settings) {
        let frame = self.root_frame.take();
        let is_in_root = frame.is_some() || body.pelvis == 0;
        let decisions = &settings.decisions;
        let placement = Placement::new(clip, performer, body, &self.table, decisions, frame);
        if placement.frame.is_root && !is_in_root {
            // The coordinates are those of the root joint after all: once more from there.
            self.root_frame = Some(placement.frame);
            self.table = PoseTable::default();
        } else {
            self.placement = Some(placement);
        }
    }

    /// Follows the analysed frames; when all are done, keeps what was found in them.
    fn follow(&mut self, is_human: bool) -> f64 {
        let Some(mut following) = self.following.take() else {
            return 1.0;
        };
        let is_complete = following.advance(FRAMES_A_STEP);
        let done = following.progress();
        if is_complete {
            let followed = following.finish();
            self.jumps = followed.jumps;
            self.feature = followed.feature.filter(|_| is_human);
            self.trails = followed.trails;
            self.track = Some(followed.track);
        } else {
            self.following = Some(following);
        }
        done
    }

    fn measure_speed(&mut self, settings: &Settings) -> f64 {
        let Some(track) = &self.track else {
            return 0.0;
        };
        let (rate_hz, cutoff_hz) = (settings.frame_rate_hz, settings.options.low_pass_hz);
        let is_human = self.body.as_ref().is_some_and(Body::is_human);
        let mut run = match self.speed_run.take() {
            Some(run) => run,
            None if is_human => SpeedRun::new(track, rate_hz, cutoff_hz).with_parts(),
            None => SpeedRun::new(track, rate_hz, cutoff_hz),
        };
        let done = run.progress();
        match run.advance(track, ROWS_A_STEP) {
            true => self.speed = Some(run.finish()),
            false => self.speed_run = Some(run),
        }
        done
    }

    fn extract(&mut self, settings: &Settings) -> Result<f64, OptionsError> {
        let Some(speed) = &self.speed else {
            return Ok(0.0);
        };
        let rate_hz = settings.frame_rate_hz;
        let mut extractor = match self.extractor.take() {
            Some(extractor) => extractor,
            None => {
                let cutoff_hz = settings.options.trend_hz;
                self.trend = speed::trend(&speed.values, rate_hz, cutoff_hz);
                Extractor::new(speed.values.clone(), rate_hz, &settings.options)?
            }
        };
        let done = extractor.progress();
        match extractor.advance(ROWS_A_STEP) {
            true => self.extraction = Some(extractor.finish()),
            false => self.extractor = Some(extractor),
        }
        Ok(done)
    }

    /// Compares the parts of a human body at the keyposes with the time around; where their speeds
    /// are gone with the motion, has them measured again.
    fn compare_parts(&mut self, is_human: bool, rate_hz: f64) {
        let (Some(speed), Some(extraction)) = (&self.speed, &self.extraction) else {
            return;
        };
        if !is_human {
            self.part_changes = Some(Vec::new());
        } else if speed.parts.is_empty() {
            self.speed = None;
        } else {
            let keyposes = extraction.keyposes();
            let change = |frame: &usize| part_change(&speed.parts, *frame, rate_hz);
            self.part_changes = Some(keyposes.iter().map(change).collect());
        }
    }

    fn finished(
        &self,
        clip: &Clip,
        performer: usize,
        settings: &Settings,
    ) -> Option<PerformerAnalysis> {
        let findings = Findings {
            clip,
            performer,
            settings,
            body: self.body.as_ref()?,
            placement: self.placement.as_ref()?,
            track: self.track.as_ref()?,
            jumps: &self.jumps,
            feature: self.feature,
            trails: self.trails,
            speed: self.speed.as_ref(),
            trend: &self.trend,
            extraction: self.extraction.as_ref(),
            part_changes: self.part_changes.as_deref().unwrap_or_default(),
        };
        Some(findings.analysis())
    }
}
