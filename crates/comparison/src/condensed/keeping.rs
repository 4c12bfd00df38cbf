//! A matrix of which only some things stay, in pieces: a matrix and the things in, the smaller matrix
//! in the same memory out.

use super::Condensed;

/// Moves the values of things that stay together. While it goes on, the matrix is neither the old nor
/// the new one.
pub(crate) struct Keeping {
    /// The things that stay, rising.
    kept: Vec<usize>,
    /// Rows moved.
    rows: usize,
    /// Values moved.
    values: usize,
}

impl Keeping {
    pub(crate) fn new(kept: Vec<usize>) -> Self {
        Self {
            kept,
            rows: 0,
            values: 0,
        }
    }

    /// The things that stay.
    pub(crate) fn kept(&self) -> &[usize] {
        &self.kept
    }

    /// Moves about `budget` values, at least a row. Returns whether all are moved.
    pub(crate) fn step(&mut self, matrix: &mut Condensed, budget: usize) -> bool {
        let until = self.values.saturating_add(budget.max(1));
        while self.rows < self.kept.len() && self.values < until {
            let row = self.kept[self.rows];
            let start = matrix.row(row).start;
            for &column in &self.kept[self.rows + 1..] {
                matrix.values[self.values] = matrix.values[start + column - row - 1];
                self.values += 1;
            }
            self.rows += 1;
        }
        let is_done = self.rows == self.kept.len();
        if is_done {
            matrix.values.truncate(self.values);
            matrix.items = self.kept.len();
        }
        is_done
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_stays_keeps_its_values() {
        let matrix = Condensed::from_fn(9, |row, column| (10 * row + column) as f64);
        for kept in [vec![0, 2, 3, 7, 8], vec![4], Vec::new(), (0..9).collect()] {
            for budget in [1, 3, 100] {
                let mut found = matrix.clone();
                let mut keeping = Keeping::new(kept.clone());
                while !keeping.step(&mut found, budget) {}
                let expected = Condensed::from_fn(kept.len(), |row, column| {
                    matrix.at(kept[row], kept[column])
                });
                assert_eq!(found, expected);
            }
        }
    }
}
