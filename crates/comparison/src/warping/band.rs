//! Which frames of the second clip a frame of the first may meet: numbers of frames and a width in, a
//! range for each frame out.

use core::ops::Range;

/// The cells |j − i (M−1)/(N−1)| ≤ max(width, (M−1)/(N−1), 1), in whole numbers: both sides are taken
/// times N−1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Band {
    rows: usize,
    columns: usize,
    /// The right side times N−1; none without a band.
    reach: Option<u128>,
}

impl Band {
    /// The band of `rows` and `columns` frames, at least one each.
    pub fn new(rows: usize, columns: usize, width: Option<usize>) -> Self {
        let last_row = (rows - 1) as u128;
        // One frame meets all.
        let width = width.filter(|_| rows > 1);
        let reach = width.map(|width| {
            (width as u128 * last_row)
                .max(last_row)
                .max((columns - 1) as u128)
        });
        Self {
            rows,
            columns,
            reach,
        }
    }

    /// The columns of a row; they never move back from one row to the next.
    pub fn row(&self, row: usize) -> Range<usize> {
        let Some(reach) = self.reach else {
            return 0..self.columns;
        };
        let last_row = (self.rows - 1) as u128;
        let middle = row as u128 * (self.columns - 1) as u128;
        let first = middle.saturating_sub(reach).div_ceil(last_row);
        let last = (middle + reach) / last_row;
        first as usize..(last as usize).min(self.columns - 1) + 1
    }

    /// Cells inside.
    pub fn cells(&self) -> usize {
        match self.reach {
            None => self.rows.saturating_mul(self.columns),
            Some(_) => {
                (0..self.rows).fold(0, |sum: usize, row| sum.saturating_add(self.row(row).len()))
            }
        }
    }

    /// Rows.
    pub fn rows(&self) -> usize {
        self.rows
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(rows: usize, columns: usize, width: usize) -> Vec<Range<usize>> {
        let band = Band::new(rows, columns, Some(width));
        (0..rows).map(|row| band.row(row)).collect()
    }

    #[test]
    fn rows_are_those_of_the_definition() {
        for (n, m, width) in [
            (7, 7, 2),
            (5, 12, 1),
            (12, 5, 0),
            (2, 9, 3),
            (9, 2, 3),
            (40, 31, 4),
        ] {
            let slope = (m - 1) as f64 / (n - 1) as f64;
            let reach = (width as f64).max(slope).max(1.0) + 1e-9;
            for (i, found) in rows(n, m, width).into_iter().enumerate() {
                let inside = |j: &usize| (*j as f64 - i as f64 * slope).abs() <= reach;
                let expected: Vec<usize> = (0..m).filter(inside).collect();
                assert_eq!(
                    found.collect::<Vec<_>>(),
                    expected,
                    "{n} {m} {width} row {i}"
                );
            }
        }
    }

    #[test]
    fn every_band_leaves_a_path() {
        for (n, m) in (2..9).flat_map(|n| (1..9).map(move |m| (n, m))) {
            let rows = rows(n, m, 0);
            assert!(rows[0].start == 0 && rows[n - 1].end == m);
            // Each row can be entered from the one before, straight or diagonally.
            for pair in rows.windows(2) {
                assert!(!pair[1].is_empty() && pair[1].start <= pair[0].end);
                assert!(pair[0].start <= pair[1].start && pair[0].end <= pair[1].end);
            }
        }
    }

    #[test]
    fn without_a_band_or_with_one_row_all_cells_are_inside() {
        assert_eq!(Band::new(3, 4, None).cells(), 12);
        assert_eq!(Band::new(1, 4, Some(1)).cells(), 4);
        assert_eq!(Band::new(3, 3, Some(1)).cells(), 7);
        assert_eq!(Band::new(usize::MAX, 3, None).cells(), usize::MAX);
    }
}
