//! Extraction: a motion speed in; keyposes and every series on the way to them out.
//!
//! Candidates are the minima of the speed. At each time scale the minima of the filtered speed are
//! matched with the surviving ones of the scale before, so that each survivor belongs to one
//! candidate; what the candidates gather on the way is their intensity, and the significant ones
//! are keyposes.
//!
//! Source: Miura et al., "Adaptive Keypose Extraction from Motion Capture Data", 2014, §3.2.

use super::candidates::{Scan, minima};
use super::correspondence::partners;
use super::intensity::{TraceEntry, Traces, traces, vertex_offset};
use super::options::{Options, OptionsError};
use super::scales::{LEVELS, Levels, usable_scales_hz};
use super::significance::{Selection, select};
use super::sureness::{Sureness, sureness};

/// Keyposes, and every series on the way to them. Frames are indices into the speed.
#[derive(Clone, Debug, PartialEq)]
pub struct Extraction {
    /// The time scales in Hz, from fine to coarse, up to the first without survivors, that one
    /// included.
    pub scales_hz: Vec<f64>,
    /// How many of the finest scales were left out because they are not below half the rate.
    pub scales_left_out: usize,
    /// Frames of the candidates, ascending.
    pub candidates: Vec<usize>,
    /// Each candidate through the time scales.
    pub traces: Traces,
    /// U of each candidate, in body heights per second.
    pub intensity: Vec<f64>,
    /// Which candidates are keyposes, and why.
    pub selection: Selection,
    /// Where the cut lies and how sure it is.
    pub sureness: Sureness,
}

impl Extraction {
    /// Frames of the keyposes, ascending.
    pub fn keyposes(&self) -> Vec<usize> {
        self.selection
            .kept
            .iter()
            .map(|&index| self.candidates[index])
            .collect()
    }

    /// Selects among the candidates once more, by the rule of other `options`; all before stays.
    pub fn select(&mut self, options: &Options) {
        self.selection = select(&self.intensity, options);
        self.sureness = sureness(&self.intensity, &self.selection.kept);
    }

    /// Candidate indices from the most to the least intense, of equals the earlier first.
    pub fn by_intensity(&self) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.candidates.len()).collect();
        let intensity = |index: usize| self.intensity[index];
        order.sort_by(|&a, &b| intensity(b).total_cmp(&intensity(a)).then(a.cmp(&b)));
        order
    }

    /// The place of each candidate in [`Self::by_intensity`], from 1.
    pub fn ranks(&self) -> Vec<usize> {
        let mut ranks = vec![0; self.candidates.len()];
        for (place, candidate) in self.by_intensity().into_iter().enumerate() {
            ranks[candidate] = place + 1;
        }
        ranks
    }
}

/// Extracts the keyposes of a motion from its `speed` (see [`crate::speed`]).
///
/// # Errors
/// An option with a value that it cannot have.
pub fn extract(
    speed: &[f64],
    frame_rate_hz: f64,
    options: &Options,
) -> Result<Extraction, OptionsError> {
    let mut extractor = Extractor::new(speed.to_vec(), frame_rate_hz, options)?;
    while !extractor.advance(usize::MAX) {}
    Ok(extractor.finish())
}

/// A minimum that has survived up to a time scale.
#[derive(Clone, Copy, Debug)]
struct Survivor {
    candidate: usize,
    frame: usize,
}

/// What the next step does.
#[derive(Clone, Copy, Debug)]
enum Stage {
    /// Makes ready the next filters.
    Start,
    /// Filters.
    Filter,
    /// Looks for the minima of the filtered levels, from a sample on.
    Scan(usize),
    /// Matches one of the filtered levels.
    Match(usize),
}

/// An extraction cut into steps.
#[derive(Clone, Debug)]
pub struct Extractor {
    speed: Vec<f64>,
    frame_rate_hz: f64,
    options: Options,
    /// The least depth of a minimum, at every scale.
    floor: f64,
    scales_hz: Vec<f64>,
    scales_left_out: usize,
    candidates: Vec<usize>,
    survivors: Vec<Survivor>,
    /// The scales from here on are still to do.
    next_scale: usize,
    levels: Levels,
    /// The minima of each of the levels.
    scans: [Scan; LEVELS],
    stage: Stage,
    entries: Vec<TraceEntry>,
}

impl Extractor {
    /// Finds the candidates, and makes ready for the rest.
    ///
    /// # Errors
    /// An option with a value that it cannot have.
    pub fn new(
        speed: Vec<f64>,
        frame_rate_hz: f64,
        options: &Options,
    ) -> Result<Self, OptionsError> {
        options.validate()?;
        let scales_hz = usable_scales_hz(options, frame_rate_hz);
        let floor = options.depth_floor * speed.iter().copied().fold(0.0, f64::max);
        let candidates = minima(&speed, floor);
        let survivor = |(candidate, &frame)| Survivor { candidate, frame };
        Ok(Self {
            frame_rate_hz,
            options: *options,
            floor,
            scales_left_out: options.scales_hz().len() - scales_hz.len(),
            scales_hz,
            survivors: candidates.iter().enumerate().map(survivor).collect(),
            candidates,
            next_scale: 0,
            levels: Levels::default(),
            scans: core::array::from_fn(|_| Scan::new(floor)),
            stage: Stage::Start,
            entries: Vec::new(),
            speed,
        })
    }

    /// Works for about `budget` rows of four levels, or matches one level. True when done.
    pub fn advance(&mut self, budget: usize) -> bool {
        if self.is_done() {
            return true;
        }
        match self.stage {
            Stage::Start => {
                let scales_hz = &self.scales_hz[self.next_scale..];
                self.levels
                    .start(scales_hz, self.frame_rate_hz, self.speed.len());
                self.stage = Stage::Filter;
            }
            Stage::Filter if self.levels.advance(&self.speed, budget) => {
                self.scans = core::array::from_fn(|_| Scan::new(self.floor));
                self.stage = Stage::Scan(0);
            }
            Stage::Filter => {}
            Stage::Scan(row) => self.scan(row, budget),
            Stage::Match(level) => {
                self.match_level(level);
                self.next_scale += 1;
                let is_last = level + 1 == self.levels.count();
                self.stage = if is_last {
                    Stage::Start
                } else {
                    Stage::Match(level + 1)
                };
            }
        }
        self.is_done()
    }

    /// The part done, from 0 to 1.
    pub fn progress(&self) -> f64 {
        match self.is_done() {
            true => 1.0,
            false => self.next_scale as f64 / self.scales_hz.len() as f64,
        }
    }

    /// The extraction, once [`Extractor::advance`] has said true.
    pub fn finish(mut self) -> Extraction {
        let traces = traces(self.candidates.len(), &self.entries);
        let intensity = traces.intensity();
        let selection = select(&intensity, &self.options);
        self.scales_hz.truncate(self.next_scale);
        Extraction {
            scales_hz: self.scales_hz,
            scales_left_out: self.scales_left_out,
            candidates: self.candidates,
            traces,
            sureness: sureness(&intensity, &selection.kept),
            selection,
            intensity,
        }
    }

    fn is_done(&self) -> bool {
        self.survivors.is_empty() || self.next_scale == self.scales_hz.len()
    }

    /// Looks for the minima of all levels at once: their samples lie side by side.
    fn scan(&mut self, row: usize, budget: usize) {
        let rows = self.levels.rows();
        let end = row.saturating_add(budget).min(rows.len());
        for lanes in &rows[row..end] {
            for (scan, level) in self.scans.iter_mut().zip(lanes.chunks_exact(2)) {
                scan.take(level[0]);
            }
        }
        self.stage = match end == rows.len() {
            true => Stage::Match(0),
            false => Stage::Scan(end),
        };
    }

    /// Matches the minima of one level with the survivors, and notes what they gather.
    fn match_level(&mut self, level: usize) {
        let levels = &self.levels;
        let scan = core::mem::replace(&mut self.scans[level], Scan::new(self.floor));
        let minima = scan.finish();
        self.survivors = matched(&self.survivors, &minima);
        for &Survivor { candidate, frame } in &self.survivors {
            // A minimum is never the first or the last sample.
            let [before, at, after] = [frame - 1, frame, frame + 1].map(|n| levels.slow(level, n));
            self.entries.push(TraceEntry {
                candidate,
                frame,
                place: frame as f64 + vertex_offset(before, at, after),
                contribution: (at - levels.slower(level, frame)).abs(),
            });
        }
    }
}

/// The survivors that have a partner among `minima`, moved to it.
fn matched(survivors: &[Survivor], minima: &[usize]) -> Vec<Survivor> {
    let frames: Vec<usize> = survivors.iter().map(|survivor| survivor.frame).collect();
    let moved = |(index, frame): (usize, usize)| Survivor {
        candidate: survivors[index].candidate,
        frame,
    };
    if minima.len() <= survivors.len() {
        let partners = partners(minima, &frames);
        partners
            .into_iter()
            .zip(minima.iter().copied())
            .map(moved)
            .collect()
    } else {
        let partners = partners(&frames, minima);
        partners
            .into_iter()
            .map(|partner| minima[partner])
            .enumerate()
            .map(moved)
            .collect()
    }
}

#[cfg(test)]
mod tests;
