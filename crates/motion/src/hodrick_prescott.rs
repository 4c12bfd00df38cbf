//! The Hodrick–Prescott filter: signals in, the same signals without their fast part out.
//!
//! `x = argmin Σ (y − x)² + λ Σ (Δ²x)²`, that is `(I + λ KᵀK) x = y` with K the (N−2) × N second
//! difference. The gain at the frequency f is `1 / (1 + 16 λ sin⁴(π f / fs))`.
//!
//! The dual system `(K Kᵀ + I/λ) w = K y`, `x = y − Kᵀ w` is solved instead: at low cut-offs it
//! keeps two to five digits more. Its matrix is pentadiagonal and the same read backwards, so
//! that one factorisation serves three passes over the signal:
//!
//! 1. up: eliminate `K y`;
//! 2. down: substitute w, and eliminate, downward, the residual `K (y − Kᵀ w) − w/λ`;
//! 3. up: substitute the correction δ of this one step of refinement, `x = y − Kᵀ w − Kᵀ δ`.
//!
//! `L` lanes are solved side by side: columns that share λ, or one signal with several λ. A lane's
//! bits do not depend on its neighbours.
//!
//! Source: R. J. Hodrick, E. C. Prescott, "Postwar U.S. Business Cycles", 1997; used on motion in
//! Miura et al., "Adaptive Keypose Extraction from Motion Capture Data", 2014, eq. 1–4.

mod factors;

use std::f64::consts::PI;

use factors::{FactorRow, Factors};

/// λ of the filter whose gain is one half at `cutoff_hz`, at `rate_hz` samples a second:
/// `1 / (16 sin⁴(π f_c / fs))`.
pub fn lambda_of_cutoff(cutoff_hz: f64, rate_hz: f64) -> f64 {
    let sine = libm::sin(PI * cutoff_hz / rate_hz);
    let square = sine * sine;
    1.0 / (16.0 * (square * square))
}

/// Filters one signal: `signal` with the cut-off `cutoff_hz`, as a new series.
///
/// A cut-off at or above half the rate leaves the signal as it is.
pub fn low_pass(signal: &[f64], cutoff_hz: f64, rate_hz: f64) -> Vec<f64> {
    let mut run = LowPass::new(signal.len(), cutoff_hz, rate_hz);
    while !run.advance(signal, usize::MAX) {}
    run.finish()
}

/// [`low_pass`] cut into steps.
#[derive(Clone, Debug)]
pub struct LowPass {
    /// None: the cut-off leaves the signal as it is.
    filter: Option<LaneFilter<1>>,
    solution: Solution<1>,
}

impl LowPass {
    /// Makes ready for a signal of `len` samples.
    pub fn new(len: usize, cutoff_hz: f64, rate_hz: f64) -> Self {
        let filter = (cutoff_hz < rate_hz / 2.0)
            .then(|| LaneFilter::new(len, [lambda_of_cutoff(cutoff_hz, rate_hz)]));
        let mut solution = Solution::default();
        if let Some(filter) = &filter {
            filter.start(&mut solution);
        }
        Self { filter, solution }
    }

    /// Works for `budget` rows, always on the same `signal`; a signal of N samples takes 3 N rows.
    /// True when done.
    pub fn advance(&mut self, signal: &[f64], budget: usize) -> bool {
        match &self.filter {
            Some(filter) => filter.advance(&Repeated(signal), &mut self.solution, budget),
            None => {
                self.solution.dual = signal.iter().map(|sample| [*sample]).collect();
                true
            }
        }
    }

    /// The filtered signal, once [`LowPass::advance`] has said true.
    pub fn finish(self) -> Vec<f64> {
        self.solution.dual.into_flattened()
    }
}

/// Where the samples of `L` lanes come from.
pub trait Rows<const L: usize> {
    /// Sample `n` of every lane.
    fn row(&self, n: usize) -> [f64; L];
}

/// One signal in every lane.
#[derive(Clone, Copy, Debug)]
pub struct Repeated<'a>(pub &'a [f64]);

impl<const L: usize> Rows<L> for Repeated<'_> {
    #[inline(always)]
    fn row(&self, n: usize) -> [f64; L] {
        [self.0[n]; L]
    }
}

/// Rows that lie ready.
impl<const L: usize> Rows<L> for Vec<[f64; L]> {
    #[inline(always)]
    fn row(&self, n: usize) -> [f64; L] {
        self[n]
    }
}

/// The filter of `L` values of λ, one a lane, for signals of one length.
#[derive(Clone, Debug)]
pub struct LaneFilter<const L: usize> {
    len: usize,
    factors: Factors<L>,
}

impl<const L: usize> LaneFilter<L> {
    /// Factorises the `L` systems for signals of `len` samples.
    pub fn new(len: usize, lambda: [f64; L]) -> Self {
        Self {
            len,
            factors: Factors::new(len.saturating_sub(2), lambda),
        }
    }

    /// Makes `solution` ready for new samples, reusing its memory.
    pub fn start(&self, solution: &mut Solution<L>) {
        solution.begin(self.len);
        solution.carry = [[0.0; L]; 6];
        solution.position = 0;
        solution.pass = if self.len < 3 {
            Pass::Copy
        } else {
            Pass::Eliminate
        };
    }

    /// Works on `solution` for `budget` rows, after [`LaneFilter::start`] and always with the same
    /// samples; a signal of N samples takes 3 N rows. True when it is solved.
    pub fn advance<R: Rows<L>>(
        &self,
        samples: &R,
        solution: &mut Solution<L>,
        budget: usize,
    ) -> bool {
        let mut left = budget;
        while left > 0 && solution.pass != Pass::Done {
            let end = solution.len().min(solution.position.saturating_add(left));
            left -= end - solution.position;
            solution.reach(end);
            match solution.pass {
                Pass::Copy => solution.copy(samples, end),
                Pass::Eliminate => self.eliminate(samples, solution, end),
                Pass::Refine => self.refine(samples, solution, end),
                Pass::Correct => self.correct(samples, solution, end),
                Pass::Done => {}
            }
            solution.position = end;
            solution.end_pass();
        }
        solution.pass == Pass::Done
    }

    /// Pass 1, up: `partial` becomes the eliminated `K y`.
    fn eliminate<R: Rows<L>>(&self, samples: &R, solution: &mut Solution<L>, end: usize) {
        let unknowns = solution.len() - 2;
        let [mut partial_1, mut partial_2, ..] = solution.carry;
        for index in solution.position..end.min(unknowns) {
            let (y_0, y_1) = (samples.row(index), samples.row(index + 1));
            let bend = second_differences(&y_0, &y_1, &samples.row(index + 2));
            let partial = eliminated(self.factors.row(index), &bend, &partial_1, &partial_2);
            solution.partial[index] = partial;
            (partial_2, partial_1) = (partial_1, partial);
        }
        solution.carry[..2].copy_from_slice(&[partial_1, partial_2]);
    }

    /// Pass 2, down: `dual` becomes w, `partial` the downward eliminated residual.
    ///
    /// Sample k needs w(k−2), so that the residual follows the substitution two rows behind.
    fn refine<R: Rows<L>>(&self, samples: &R, solution: &mut Solution<L>, end: usize) {
        let (len, unknowns) = (solution.len(), solution.len() - 2);
        let [
            mut w_1,
            mut w_2,
            mut x_1,
            mut x_2,
            mut partial_1,
            mut partial_2,
        ] = solution.carry;
        for k in (len - end..len - solution.position).rev() {
            let mut w_0 = [0.0; L];
            if let Some(index) = k.checked_sub(2) {
                let factor = self.factors.row(index);
                w_0 = substituted(factor, &solution.partial[index], &w_1, &w_2);
                solution.dual[index] = w_0;
            }
            let x_0 = primal(&samples.row(k), &w_2, &w_1, &w_0);
            if k < unknowns {
                let mut residual = second_differences(&x_0, &x_1, &x_2);
                for (lane, residual) in residual.iter_mut().enumerate() {
                    *residual -= w_2[lane] * self.factors.inverse_lambda[lane];
                }
                let factor = self.factors.row(unknowns - 1 - k);
                let partial = eliminated(factor, &residual, &partial_1, &partial_2);
                solution.partial[k] = partial;
                (partial_2, partial_1) = (partial_1, partial);
            }
            (w_2, w_1) = (w_1, w_0);
            (x_2, x_1) = (x_1, x_0);
        }
        solution.carry = [w_1, w_2, x_1, x_2, partial_1, partial_2];
    }

    /// Pass 3, up: `dual` becomes the filtered signal.
    ///
    /// w is many times the signal at low cut-offs, so that the last places of w + δ would be
    /// missed in x: `Kᵀ w`, exact but for the last place, and `Kᵀ δ` are taken apart.
    fn correct<R: Rows<L>>(&self, samples: &R, solution: &mut Solution<L>, end: usize) {
        let unknowns = solution.len() - 2;
        let [mut delta_1, mut delta_2, mut w_1, mut w_2, ..] = solution.carry;
        for k in solution.position..end {
            let (mut w_0, mut delta_0) = ([0.0; L], [0.0; L]);
            if k < unknowns {
                let factor = self.factors.row(unknowns - 1 - k);
                w_0 = solution.dual[k];
                delta_0 = substituted(factor, &solution.partial[k], &delta_1, &delta_2);
            }
            let nearly = primal(&samples.row(k), &w_0, &w_1, &w_2);
            solution.dual[k] = primal(&nearly, &delta_0, &delta_1, &delta_2);
            (w_2, w_1) = (w_1, w_0);
            (delta_2, delta_1) = (delta_1, delta_0);
        }
        solution.carry[..4].copy_from_slice(&[delta_1, delta_2, w_1, w_2]);
    }
}

/// `K` at one row: the bend of three neighbours, exact where they are close.
#[inline(always)]
fn second_differences<const L: usize>(
    first: &[f64; L],
    middle: &[f64; L],
    last: &[f64; L],
) -> [f64; L] {
    let mut bend = [0.0; L];
    for lane in 0..L {
        bend[lane] = (first[lane] - middle[lane]) - (middle[lane] - last[lane]);
    }
    bend
}

/// One row of the elimination with the scaled lower triangle.
#[inline(always)]
fn eliminated<const L: usize>(
    factor: &FactorRow<L>,
    right: &[f64; L],
    before_1: &[f64; L],
    before_2: &[f64; L],
) -> [f64; L] {
    let mut value = [0.0; L];
    for lane in 0..L {
        let rest = right[lane] - factor.beside[lane] * before_1[lane] - before_2[lane];
        value[lane] = rest * factor.inverse_pivot[lane];
    }
    value
}

/// One row of the substitution with the unit triangle.
#[inline(always)]
fn substituted<const L: usize>(
    factor: &FactorRow<L>,
    partial: &[f64; L],
    next_1: &[f64; L],
    next_2: &[f64; L],
) -> [f64; L] {
    let mut value = [0.0; L];
    for lane in 0..L {
        value[lane] = partial[lane]
            - factor.below[lane] * next_1[lane]
            - factor.inverse_pivot[lane] * next_2[lane];
    }
    value
}

/// `x = y − Kᵀ w` at one sample, from the three w that meet there.
#[inline(always)]
fn primal<const L: usize>(
    y: &[f64; L],
    first: &[f64; L],
    middle: &[f64; L],
    last: &[f64; L],
) -> [f64; L] {
    let mut x = second_differences(first, middle, last);
    for lane in 0..L {
        x[lane] = y[lane] - x[lane];
    }
    x
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Pass {
    /// Fewer than three samples: the signal itself.
    Copy,
    Eliminate,
    Refine,
    Correct,
    Done,
}

/// Scratch space and, in the end, result of a [`LaneFilter`]: two tables of N × `L` numbers.
#[derive(Clone, Debug)]
pub struct Solution<const L: usize> {
    len: usize,
    dual: Vec<[f64; L]>,
    partial: Vec<[f64; L]>,
    carry: [[f64; L]; 6],
    pass: Pass,
    position: usize,
}

impl<const L: usize> Default for Solution<L> {
    fn default() -> Self {
        Self {
            len: 0,
            dual: Vec::new(),
            partial: Vec::new(),
            carry: [[0.0; L]; 6],
            pass: Pass::Done,
            position: 0,
        }
    }
}

impl<const L: usize> Solution<L> {
    /// The filtered samples, row by row, once [`LaneFilter::advance`] has said true.
    pub fn rows(&self) -> &[[f64; L]] {
        &self.dual
    }

    fn len(&self) -> usize {
        self.len
    }

    /// Room for `len` samples.
    fn begin(&mut self, len: usize) {
        self.len = len;
        for table in [&mut self.dual, &mut self.partial] {
            table.truncate(len);
            table.reserve_exact(len - table.len());
        }
    }

    /// The first pass goes up through the tables and fills them on its way: to fill them whole
    /// would be a step too long.
    fn reach(&mut self, end: usize) {
        if self.dual.len() < end {
            self.dual.resize(end, [0.0; L]);
            self.partial.resize(end, [0.0; L]);
        }
    }

    fn copy<R: Rows<L>>(&mut self, samples: &R, end: usize) {
        for index in self.position..end {
            self.dual[index] = samples.row(index);
        }
    }

    /// Goes to the next pass if this one has reached its end.
    fn end_pass(&mut self) {
        if self.position < self.len() {
            return;
        }
        self.position = 0;
        self.carry = [[0.0; L]; 6];
        self.pass = match self.pass {
            Pass::Eliminate => Pass::Refine,
            Pass::Refine => Pass::Correct,
            Pass::Copy | Pass::Correct | Pass::Done => Pass::Done,
        };
    }
}

#[cfg(test)]
mod tests;
