//! Classical scaling of vectors, and what it shares with that of a matrix: vectors in, a map with its own
//! axes out.

use super::spectrum::spectrum;
use super::{Map, Place};
use crate::feature::{FEATURE_LENGTH, Vector};

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

/// The part that the two largest values have in the positive ones.
pub(super) fn spread(values: &[f64]) -> f64 {
    let sum = |values: &[f64]| values.iter().fold(0.0, |sum, value| sum + value.max(0.0));
    let all = sum(values);
    match all > 0.0 {
        true => sum(&values[..values.len().min(2)]) / all,
        false => 1.0,
    }
}

/// Sizes that differ by less than this part are equal: of two clips both are, but for rounding.
const EQUAL: f64 = 1e-9;

/// Each axis turned so that its largest coordinate by size, of equals the first, is positive.
pub(super) fn turned_to_positive(mut places: Vec<Place>) -> Vec<Place> {
    for axis in 0..2 {
        let largest = places.iter().fold(0.0_f64, |largest, place| {
            match place[axis].abs() > largest.abs() * (1.0 + EQUAL) {
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

#[cfg(test)]
mod tests;
