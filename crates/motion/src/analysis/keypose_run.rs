//! One performer's keyposes, from the track to what explains them, a part at a step: speed, trend,
//! the candidates through the time scales, which of them are kept, and what slows down there.

use super::settings::Settings;
use crate::body::BODY_PARTS;
use crate::hodrick_prescott::LowPass;
use crate::keypose::{Extraction, Extractor, Options, OptionsError};
use crate::part_change::{PartChange, part_change};
use crate::speed::{MotionSpeed, SpeedRun};
use crate::track::PelvisTrack;

/// Rows filtered in one step, eight columns each.
const ROWS_A_STEP: usize = 1 << 15;

/// Parts of the whole that are done when speed and trend are.
const SPEED_KNOWN: f64 = 0.4;
const TREND_KNOWN: f64 = 0.42;

/// The pieces, in the order in which they are made.
#[derive(Clone, Debug, Default)]
pub struct KeyposeRun {
    speed_run: Option<SpeedRun>,
    speed: Option<MotionSpeed>,
    trend_run: Option<LowPass>,
    trend: Option<Vec<f64>>,
    extractor: Option<Extractor>,
    extraction: Option<Extraction>,
    /// Whether the extraction's selection was made by another rule.
    is_selection_stale: bool,
    part_changes: Option<Vec<PartChange>>,
}

/// The finished pieces.
#[derive(Clone, Copy, Debug)]
pub struct Extracted<'a> {
    pub speed: &'a MotionSpeed,
    pub trend: &'a [f64],
    pub extraction: &'a Extraction,
    pub part_changes: &'a [PartChange],
}

impl KeyposeRun {
    /// Takes away what other settings make invalid, the track being the same.
    pub fn change(&mut self, last: &Settings, next: &Settings) {
        let (before, after) = (&last.options, &next.options);
        let is_same_rate = last.frame_rate_hz == next.frame_rate_hz;
        if !is_same_rate || before.low_pass_hz != after.low_pass_hz {
            self.forget();
        }
        if before.trend_hz != after.trend_hz {
            self.trend_run = None;
            self.trend = None;
        }
        if scales_of(before) != scales_of(after) {
            self.forget_extraction();
        }
        if (before.selection, before.mojena_k) != (after.selection, after.mojena_k) {
            // An extractor at work selects by the rule that it began with.
            self.is_selection_stale = true;
            self.part_changes = None;
        }
    }

    /// Takes everything away.
    pub fn forget(&mut self) {
        *self = Self::default();
    }

    /// Frees what is as large as the poses and can be made again from them.
    pub fn drop_motion(&mut self) {
        self.speed_run = None;
        if let Some(speed) = &mut self.speed {
            speed.parts = Vec::new();
        }
    }

    /// Bytes of it.
    pub fn motion_bytes(&self) -> usize {
        let parts = self.speed.as_ref().map(|speed| speed.parts.capacity());
        parts.unwrap_or(0) * size_of::<[f64; BODY_PARTS]>()
    }

    /// All pieces, once they are made.
    pub fn extracted(&self) -> Option<Extracted<'_>> {
        let extraction = self.extraction.as_ref();
        Some(Extracted {
            speed: self.speed.as_ref()?,
            trend: self.trend.as_ref()?,
            extraction: extraction.filter(|_| !self.is_selection_stale)?,
            part_changes: self.part_changes.as_ref()?,
        })
    }

    /// Makes a part of the first missing piece. Returns the part done, below 1 until all are there.
    ///
    /// # Errors
    /// An option that cannot be.
    pub fn step(
        &mut self,
        track: &PelvisTrack,
        is_human: bool,
        settings: &Settings,
    ) -> Result<f64, OptionsError> {
        let Some(speed) = &self.speed else {
            return Ok(SPEED_KNOWN * self.measure_speed(track, is_human, settings));
        };
        if self.trend.is_none() {
            let mut run = self.trend_run.take().unwrap_or_else(|| {
                let (len, cutoff_hz) = (speed.values.len(), settings.options.trend_hz);
                LowPass::new(len, cutoff_hz, settings.frame_rate_hz)
            });
            match run.advance(&speed.values, 4 * ROWS_A_STEP) {
                true => self.trend = Some(run.finish()),
                false => self.trend_run = Some(run),
            }
            return Ok(SPEED_KNOWN);
        }
        let Some(extraction) = &mut self.extraction else {
            let done = self.extract(settings)?;
            return Ok(TREND_KNOWN + (0.98 - TREND_KNOWN) * done);
        };
        if self.is_selection_stale {
            extraction.select(&settings.options);
            self.is_selection_stale = false;
            return Ok(0.98);
        }
        self.compare_parts(is_human, settings.frame_rate_hz);
        Ok(0.99)
    }

    fn forget_extraction(&mut self) {
        self.extractor = None;
        self.extraction = None;
        self.is_selection_stale = false;
        self.part_changes = None;
    }

    fn measure_speed(&mut self, track: &PelvisTrack, is_human: bool, settings: &Settings) -> f64 {
        let (rate_hz, cutoff_hz) = (settings.frame_rate_hz, settings.options.low_pass_hz);
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
        let mut extractor = match self.extractor.take() {
            Some(extractor) => extractor,
            None => {
                let rate_hz = settings.frame_rate_hz;
                self.is_selection_stale = false;
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
}

/// What the candidates and their traces depend on beside the speed.
fn scales_of(options: &Options) -> [f64; 4] {
    let Options {
        scale_max_hz,
        scale_min_hz,
        scale_ratio,
        depth_floor,
        ..
    } = *options;
    [scale_max_hz, scale_min_hz, scale_ratio, depth_floor]
}
