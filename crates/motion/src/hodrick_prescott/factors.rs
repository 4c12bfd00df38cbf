//! The factors of the dual system: values of λ in, rows of a pentadiagonal factorisation out.

/// One row of the factors of `K Kᵀ + I/λ = (lower · pivot) · lowerᵀ`, unit lower triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FactorRow<const L: usize> {
    /// One over the pivot; also the second subdiagonal of the unit triangle, whose outermost
    /// entries are 1 before scaling.
    pub inverse_pivot: [f64; L],
    /// The first subdiagonal before scaling, left of this pivot.
    pub beside: [f64; L],
    /// The first subdiagonal of the unit triangle, below this pivot.
    pub below: [f64; L],
}

/// Factors for `L` values of λ. Only the first rows are stored: further on every row is the same.
#[derive(Clone, Debug)]
pub(super) struct Factors<const L: usize> {
    pub head: Vec<FactorRow<L>>,
    pub settled: FactorRow<L>,
    pub inverse_lambda: [f64; L],
}

impl<const L: usize> Factors<L> {
    pub fn new(unknowns: usize, lambda: [f64; L]) -> Self {
        let settled = lambda.map(Settled::new);
        let settled_row = FactorRow {
            inverse_pivot: settled.each_ref().map(|lane| lane.inverse_pivot),
            beside: settled
                .each_ref()
                .map(|lane| lane.below / lane.inverse_pivot),
            below: settled.each_ref().map(|lane| lane.below),
        };
        let inverse_lambda = lambda.map(|lambda| 1.0 / lambda);
        let longest = settled.iter().map(|lane| lane.from).max().unwrap_or(0);
        let mut deviations = [[Deviation::default(); 2]; L];
        let mut head = Vec::with_capacity(unknowns.min(longest));
        for index in 0..unknowns.min(longest) {
            let mut row = settled_row;
            for (lane, [before, last]) in deviations.iter_mut().enumerate() {
                if index < settled[lane].from {
                    let next = Deviation::next(*before, *last, inverse_lambda[lane]);
                    row.beside[lane] = if index == 0 { 0.0 } else { -2.0 - before.below };
                    row.inverse_pivot[lane] = 1.0 - next.inverse_pivot;
                    row.below[lane] = next.below - 2.0;
                    (*before, *last) = (*last, next);
                }
            }
            head.push(row);
        }
        Self {
            head,
            settled: settled_row,
            inverse_lambda,
        }
    }

    #[inline(always)]
    pub fn row(&self, index: usize) -> &FactorRow<L> {
        self.head.get(index).unwrap_or(&self.settled)
    }
}

/// What the rows of the factors tend to, in closed form.
///
/// The symbol of the matrix, `(2 − z − 1/z)² + 1/λ`, is `pivot · u(z) · u(1/z)` with
/// `u(z) = 1 + below · z + z² / pivot`, whose roots are one over the two inside the unit circle.
/// The rows come nearer by the square of such a root's modulus a row, while rounding keeps a
/// computed row off by many units in the last place for ever: beyond the first rows the closed
/// form is the better one, and it takes no memory.
#[derive(Clone, Copy, Debug)]
pub(super) struct Settled {
    inverse_pivot: f64,
    below: f64,
    /// The row from which it holds to the last place.
    pub from: usize,
}

impl Settled {
    /// The root is z with `z + 1/z = 2 − i s`, `s = 1 / √λ`.
    pub fn new(lambda: f64) -> Self {
        let s = 1.0 / lambda.sqrt();
        let modulus = s * (1.0 + s * s / 16.0).sqrt();
        let shrink = ((modulus - s * s / 4.0) / 2.0).sqrt();
        let (real, imaginary) = (1.0 - shrink, s / (2.0 * shrink) - s / 2.0);
        let square = real * real + imaginary * imaginary;
        // Rows until square^rows is below half a unit in the last place, and two for safety.
        let rows = libm::ceil(54.0 * std::f64::consts::LN_2 / -libm::log(square)) + 2.0;
        Self {
            inverse_pivot: square,
            below: -2.0 * real,
            from: rows as usize,
        }
    }
}

/// How far a row of the factors is from that of λ = ∞ far down: 1 − 1/pivot and 2 + below.
#[derive(Clone, Copy, Debug)]
struct Deviation {
    inverse_pivot: f64,
    below: f64,
}

impl Default for Deviation {
    /// The rows before the first: zeros.
    fn default() -> Self {
        Self {
            inverse_pivot: 1.0,
            below: 2.0,
        }
    }
}

impl Deviation {
    fn next(before: Self, last: Self, inverse_lambda: f64) -> Self {
        let pivot = inverse_lambda
            + 2.0 * (last.below - before.below)
            + last.below * before.below
            + before.inverse_pivot;
        Self {
            inverse_pivot: pivot / (1.0 + pivot),
            below: (2.0 * pivot - last.below) / (1.0 + pivot),
        }
    }
}
