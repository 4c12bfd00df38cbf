//! Classical scaling: vectors or a condensed matrix in, a map with its own axes out.

use super::spectrum::{Spectrum, spectrum};
use super::{Map, Place};
use crate::condensed::Condensed;
use crate::feature::{FEATURE_LENGTH, Vector};
use wide::f64x4;

/// With so many items or fewer the eigenvalues of a matrix are all found.
const EXACT_ITEMS: usize = 300;

/// The most multiplications by a larger matrix.
const MOST_STEPS: usize = 200;

/// The map of vectors by their Euclidean distances: their principal axes, exact.
#[must_use]
pub fn of_vectors(vectors: &[Vector]) -> Map {
    let middle = middle_of(vectors);
    let from_middle =
        |vector: &Vector| -> Vector { core::array::from_fn(|index| vector[index] - middle[index]) };
    let scatter = scatter_of(vectors.iter().map(from_middle));
    let apply = |from: &[f64], to: &mut [f64]| {
        for (sum, row) in to.iter_mut().zip(&scatter) {
            *sum = dot(row, from);
        }
    };
    let found = spectrum(FEATURE_LENGTH, FEATURE_LENGTH, apply);
    let place = |vector: &Vector| {
        found
            .axes
            .each_ref()
            .map(|axis| dot(axis, &from_middle(vector)))
    };
    let square = |vector: &Vector| {
        let vector = from_middle(vector);
        dot(&vector, &vector)
    };
    Map {
        places: turned_to_positive(vectors.iter().map(place).collect()),
        spread: spread(&found.values),
        squares_from_middle: vectors.iter().map(square).collect(),
    }
}

fn middle_of(vectors: &[Vector]) -> Vector {
    let mut sums = [0.0; FEATURE_LENGTH];
    for vector in vectors {
        for (sum, value) in sums.iter_mut().zip(vector) {
            *sum += value;
        }
    }
    sums.map(|sum| sum / vectors.len().max(1) as f64)
}

/// The sum of the products of the components of vectors from their middle, pair by pair.
fn scatter_of(from_middle: impl Iterator<Item = Vector>) -> [Vector; FEATURE_LENGTH] {
    let mut scatter = [[0.0; FEATURE_LENGTH]; FEATURE_LENGTH];
    for vector in from_middle {
        for (row, value) in scatter.iter_mut().zip(vector) {
            for (sum, other) in row.iter_mut().zip(vector) {
                *sum += value * other;
            }
        }
    }
    scatter
}

/// The map of any distances. Its spread is exact up to 300 items; above, it is that of 300 items
/// taken evenly, since it needs all eigenvalues.
#[must_use]
pub fn of_matrix(condensed: &Condensed) -> Map {
    let items = condensed.items;
    let means = mean_squares(condensed);
    let overall = mean(&means);
    let found = centred_spectrum(
        condensed,
        if items <= EXACT_ITEMS {
            items
        } else {
            MOST_STEPS
        },
    );
    let scale = |axis: usize| {
        found
            .values
            .get(axis)
            .map_or(0.0, |value| value.max(0.0).sqrt())
    };
    let scales = [scale(0), scale(1)];
    let place = |item: usize| [0, 1].map(|axis| scales[axis] * found.axes[axis][item]);
    Map {
        places: turned_to_positive((0..items).map(place).collect()),
        spread: match items <= EXACT_ITEMS {
            true => spread(&found.values),
            false => spread(&centred_spectrum(&sample(condensed), EXACT_ITEMS).values),
        },
        squares_from_middle: means.iter().map(|mean| mean - overall / 2.0).collect(),
    }
}

/// The spectrum of B.
fn centred_spectrum(condensed: &Condensed, most_steps: usize) -> Spectrum {
    let mut centred = vec![0.0; condensed.items];
    spectrum(condensed.items, most_steps, |from, to| {
        let middle = mean(from);
        for (value, from) in centred.iter_mut().zip(from) {
            *value = from - middle;
        }
        times_squares(condensed, &centred, to);
        let middle = mean(to);
        for value in to {
            *value = -0.5 * (*value - middle);
        }
    })
}

/// The matrix of the squared distances times a vector.
fn times_squares(condensed: &Condensed, from: &[f64], to: &mut [f64]) {
    to.fill(0.0);
    let mut rest = condensed.values.as_slice();
    for item in 0..condensed.items {
        let (row, below) = rest.split_at(condensed.items - item - 1);
        rest = below;
        let (first, after) = to[item..].split_at_mut(1);
        first[0] += times_row(row, from[item], &from[item + 1..], after);
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

/// The mean over all items of the squared distance from each.
fn mean_squares(condensed: &Condensed) -> Vec<f64> {
    let count = condensed.items.max(1) as f64;
    let mut means = vec![0.0; condensed.items];
    times_squares(condensed, &vec![1.0; condensed.items], &mut means);
    means.iter().map(|sum| sum / count).collect()
}

/// As many items as can be done exactly, evenly taken.
fn sample(condensed: &Condensed) -> Condensed {
    let item = |index: usize| index * condensed.items / EXACT_ITEMS;
    Condensed::from_fn(EXACT_ITEMS, |one, other| {
        condensed.at(item(one), item(other))
    })
}

/// The part that the two largest values have in the positive ones.
fn spread(values: &[f64]) -> f64 {
    let sum = |values: &[f64]| values.iter().fold(0.0, |sum, value| sum + value.max(0.0));
    let all = sum(values);
    match all > 0.0 {
        true => sum(&values[..values.len().min(2)]) / all,
        false => 1.0,
    }
}

/// Each axis turned so that its largest coordinate by size, of equals the first, is positive.
fn turned_to_positive(mut places: Vec<Place>) -> Vec<Place> {
    for axis in 0..2 {
        let largest = places.iter().fold(0.0_f64, |largest, place| {
            match place[axis].abs() > largest.abs() {
                true => place[axis],
                false => largest,
            }
        });
        if largest < 0.0 {
            for place in &mut places {
                place[axis] = -place[axis];
            }
        }
    }
    places
}

fn dot(one: &[f64], other: &[f64]) -> f64 {
    let products = one.iter().zip(other);
    products.fold(0.0, |sum, (one, other)| sum + one * other)
}

fn mean(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |sum, value| sum + value) / values.len().max(1) as f64
}

#[cfg(test)]
mod tests;
