//! Classical scaling of any distances, in pieces: a condensed matrix in, a map with its own axes out.

use super::Map;
use super::scaling::{spread, turned_to_positive};
use super::spectrum::{Spectrum, SpectrumSteps};
use crate::condensed::Condensed;
use wide::f64x4;

/// With so many items or fewer the eigenvalues of a matrix are all found.
const EXACT_ITEMS: usize = 300;

/// The most multiplications by a larger matrix, …
const MOST_STEPS: usize = 200;

/// … and how many are usual: only what is told of the progress hangs on it.
const USUAL_STEPS: usize = 60;

/// The map of any distances. Its spread is exact up to 300 items. Above, one part of it is an estimate:
/// the sum of all eigenvalues is known, but how much more the positive ones have than all is told of
/// 300 items taken evenly. In pieces: [`MatrixMapSteps`].
#[must_use]
pub fn of_matrix(condensed: &Condensed) -> Map {
    MatrixMapSteps::new(condensed).finish(condensed)
}

/// [`of_matrix`] in pieces. Every call takes the same matrix.
pub struct MatrixMapSteps {
    work: Work,
    /// The mean over all items of the squared distance from each.
    means: Vec<f64>,
    axes: Spectrum,
    spread: f64,
}

/// What is under way.
enum Work {
    Means(Product),
    Axes(CentredSpectrum),
    /// The spectrum of the items taken, and their matrix.
    Spread(CentredSpectrum, Condensed),
    Done,
}

impl MatrixMapSteps {
    /// Nothing known yet.
    #[must_use]
    pub fn new(condensed: &Condensed) -> Self {
        Self {
            work: Work::Means(Product::of(vec![1.0; condensed.items])),
            means: Vec::new(),
            axes: Spectrum::default(),
            spread: 1.0,
        }
    }

    /// Goes on for the time of about `budget` distances; how much is done, 0 to 1.
    pub fn step(&mut self, condensed: &Condensed, budget: usize) -> f64 {
        let is_done = match &mut self.work {
            Work::Means(product) => product.step(condensed, budget),
            Work::Axes(spectrum) => spectrum.step(condensed, budget),
            Work::Spread(spectrum, sample) => spectrum.step(sample, budget),
            Work::Done => return 1.0,
        };
        if is_done {
            self.begin_next(condensed);
        }
        self.done()
    }

    /// Does what is left; the map.
    #[must_use]
    pub fn finish(mut self, condensed: &Condensed) -> Map {
        while self.step(condensed, usize::MAX) < 1.0 {}
        let overall = mean(&self.means);
        let scale = |axis: usize| {
            let value = self.axes.values.get(axis);
            value.map_or(0.0, |value| value.max(0.0).sqrt())
        };
        let scales = [scale(0), scale(1)];
        let place = |item: usize| [0, 1].map(|axis| scales[axis] * self.axes.axes[axis][item]);
        Map {
            places: turned_to_positive((0..condensed.items).map(place).collect()),
            spread: self.spread,
            squares_from_middle: self.means.iter().map(|mean| mean - overall / 2.0).collect(),
        }
    }

    /// Keeps the piece that is done and begins the one that follows it.
    fn begin_next(&mut self, condensed: &Condensed) {
        let items = condensed.items;
        self.work = match std::mem::replace(&mut self.work, Work::Done) {
            Work::Means(product) => {
                let count = items.max(1) as f64;
                self.means = product.to.iter().map(|sum| sum / count).collect();
                let is_exact = items <= EXACT_ITEMS;
                let most = if is_exact { items } else { MOST_STEPS };
                Work::Axes(CentredSpectrum::of(items, most))
            }
            Work::Axes(spectrum) => {
                self.axes = spectrum.finish();
                if items <= EXACT_ITEMS {
                    self.spread = spread(&self.axes.values);
                    Work::Done
                } else {
                    let spectrum = CentredSpectrum::of(EXACT_ITEMS, EXACT_ITEMS);
                    Work::Spread(spectrum, sample(condensed))
                }
            }
            Work::Spread(spectrum, _) => {
                self.spread = self.spread_by_sample(&spectrum.finish().values);
                Work::Done
            }
            Work::Done => Work::Done,
        };
    }

    /// The part of the two largest eigenvalues in the positive ones, by all those of some items.
    fn spread_by_sample(&self, of_sample: &[f64]) -> f64 {
        let add = |sum: f64, value: &f64| sum + value;
        let positive = of_sample.iter().filter(|value| **value > 0.0);
        let (positive, all) = (positive.fold(0.0, add), of_sample.iter().fold(0.0, add));
        let trace = mean(&self.means) / 2.0 * self.means.len() as f64;
        let shown = self.axes.values.iter().take(2);
        let shown = shown.fold(0.0, |sum, value| sum + value.max(0.0));
        match all > 0.0 && trace > 0.0 {
            true => (shown / trace * (all / positive)).min(1.0),
            false => spread(of_sample),
        }
    }

    /// An estimate: how many products are needed is known at the end.
    fn done(&self) -> f64 {
        match &self.work {
            Work::Means(_) => 0.0,
            Work::Axes(spectrum) => 0.9 * spectrum.done(),
            Work::Spread(spectrum, _) => 0.9 + 0.099 * spectrum.done(),
            Work::Done => 1.0,
        }
    }
}

/// The spectrum of B.
struct CentredSpectrum {
    steps: SpectrumSteps,
    /// That of the matrix of the squared distances and the vector wanted, from its mean.
    product: Option<Product>,
}

impl CentredSpectrum {
    fn of(items: usize, most_steps: usize) -> Self {
        Self {
            steps: SpectrumSteps::new(items, most_steps),
            product: None,
        }
    }

    /// Whether it is found.
    fn step(&mut self, condensed: &Condensed, budget: usize) -> bool {
        let Some(vector) = self.steps.wanted() else {
            return self.steps.look();
        };
        let product = self.product.get_or_insert_with(|| {
            let middle = mean(vector);
            Product::of(vector.iter().map(|value| value - middle).collect())
        });
        if product.step(condensed, budget)
            && let Some(Product { mut to, .. }) = self.product.take()
        {
            let middle = mean(&to);
            for value in &mut to {
                *value = -0.5 * (*value - middle);
            }
            self.steps.take(to);
        }
        false
    }

    fn done(&self) -> f64 {
        (self.steps.products() as f64 / USUAL_STEPS as f64).min(1.0)
    }

    fn finish(self) -> Spectrum {
        self.steps.finish()
    }
}

/// The product of the matrix of the squared distances and a vector, row by row.
struct Product {
    from: Vec<f64>,
    to: Vec<f64>,
    row: usize,
}

impl Product {
    fn of(from: Vec<f64>) -> Self {
        Self {
            to: vec![0.0; from.len()],
            from,
            row: 0,
        }
    }

    /// Whether all rows are done.
    fn step(&mut self, condensed: &Condensed, budget: usize) -> bool {
        let mut left = budget.max(1);
        while self.row < condensed.items && left > 0 {
            let row = &condensed.values[condensed.row(self.row)];
            let (first, after) = self.to[self.row..].split_at_mut(1);
            let from = &self.from[self.row..];
            first[0] += times_row(row, from[0], &from[1..], after);
            left = left.saturating_sub(1 + row.len());
            self.row += 1;
        }
        self.row == condensed.items
    }
}

/// Adds `value` times the squared row to `to`; returns the squared row times `from`.
fn times_row(row: &[f64], value: f64, from: &[f64], to: &mut [f64]) -> f64 {
    let mut sums = f64x4::ZERO;
    let (rows, row_rest) = row.as_chunks::<4>();
    let (froms, from_rest) = from.as_chunks::<4>();
    let (tos, to_rest) = to.as_chunks_mut::<4>();
    for ((row, from), to) in rows.iter().zip(froms).zip(tos) {
        let row = f64x4::new(*row);
        let squares = row * row;
        sums += squares * f64x4::new(*from);
        *to = (f64x4::new(*to) + squares * f64x4::splat(value)).to_array();
    }
    let mut sum = sums.reduce_add();
    for ((row, from), to) in row_rest.iter().zip(from_rest).zip(to_rest) {
        sum += row * row * from;
        *to += row * row * value;
    }
    sum
}

/// As many items as can be done exactly, evenly taken.
fn sample(condensed: &Condensed) -> Condensed {
    let item = |index: usize| index * condensed.items / EXACT_ITEMS;
    Condensed::from_fn(EXACT_ITEMS, |one, other| {
        condensed.at(item(one), item(other))
    })
}

fn mean(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |sum, value| sum + value) / values.len().max(1) as f64
}
