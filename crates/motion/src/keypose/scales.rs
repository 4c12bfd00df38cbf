//! Time scales: a speed and some cut-offs in; at each, the filtered speed and its slower half out.
//!
//! Level i of the scale `f_i` holds `L_i = HP(v, f_i)` and `A_i = HP(v, f_i / 2)`, side by side in
//! the lanes of one filter, four levels at a time.

use super::options::Options;
use crate::hodrick_prescott::{LaneFilter, Repeated, Solution, lambda_of_cutoff};

/// Levels that are filtered together.
pub const LEVELS: usize = 4;
/// Lanes of their filter.
pub const LANES: usize = 2 * LEVELS;

/// The scales of `options` below half the rate, from fine to coarse, in Hz.
pub fn usable_scales_hz(options: &Options, rate_hz: f64) -> Vec<f64> {
    let mut scales = options.scales_hz();
    scales.retain(|&hz| hz < rate_hz / 2.0);
    scales
}

/// The filters of up to four neighbouring scales, and their state while they work.
#[derive(Clone, Debug, Default)]
pub struct Levels {
    filter: Option<LaneFilter<LANES>>,
    solution: Solution<LANES>,
    count: usize,
}

impl Levels {
    /// Makes ready for the first scales of `scales_hz` (at least one) over `len` samples.
    pub fn start(&mut self, scales_hz: &[f64], rate_hz: f64, len: usize) {
        self.count = scales_hz.len().min(LEVELS);
        let lambda = std::array::from_fn(|lane| {
            let scale_hz = scales_hz[(lane / 2).min(self.count - 1)];
            let cutoff_hz = if lane % 2 == 0 {
                scale_hz
            } else {
                scale_hz / 2.0
            };
            lambda_of_cutoff(cutoff_hz, rate_hz)
        });
        let filter = LaneFilter::new(len, lambda);
        filter.start(&mut self.solution);
        self.filter = Some(filter);
    }

    /// Filters `speed` for `budget` rows of a pass. True when all levels are there.
    pub fn advance(&mut self, speed: &[f64], budget: usize) -> bool {
        match &self.filter {
            Some(filter) => filter.advance(&Repeated(speed), &mut self.solution, budget),
            None => true,
        }
    }

    /// How many levels these are.
    pub fn count(&self) -> usize {
        self.count
    }

    /// The filtered samples, row by row: lanes 2 k and 2 k + 1 are the level k of these, and its
    /// slower half.
    pub fn rows(&self) -> &[[f64; LANES]] {
        self.solution.rows()
    }

    /// `L_i` at sample `n` of the level `index` of these.
    #[inline(always)]
    pub fn slow(&self, index: usize, n: usize) -> f64 {
        self.solution.rows()[n][2 * index]
    }

    /// `A_i` at sample `n` of the level `index` of these.
    #[inline(always)]
    pub fn slower(&self, index: usize, n: usize) -> f64 {
        self.solution.rows()[n][2 * index + 1]
    }
}
