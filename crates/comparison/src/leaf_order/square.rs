//! Values of pairs of places.

use super::least_sums::Part;
use std::ops::Range;

/// A square matrix, symmetric once filled.
pub(super) struct Square {
    side: usize,
    values: Vec<f64>,
}

impl Square {
    pub(super) fn of(side: usize) -> Self {
        Self {
            side,
            values: vec![0.0; side * side],
        }
    }

    pub(super) fn at(&self, row: usize, column: usize) -> f64 {
        self.values[row * self.side + column]
    }

    pub(super) fn set_pair(&mut self, row: usize, column: usize, value: f64) {
        self.values[row * self.side + column] = value;
        self.values[column * self.side + row] = value;
    }

    pub(super) fn part(&self, rows: &Range<usize>, columns: &Range<usize>) -> Part<'_> {
        Part {
            values: &self.values[rows.start * self.side + columns.start..],
            stride: self.side,
            rows: rows.len(),
            columns: columns.len(),
        }
    }
}
