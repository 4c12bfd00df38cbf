//! Two matrices in; their product out, in which + stands for · and the minimum for +.

use wide::f64x4;

/// Rows and columns of the result that are found together.
const WIDTH: usize = 4;

/// A part of a matrix: `rows` × `columns`, its rows `stride` numbers apart.
#[derive(Clone, Copy)]
pub(super) struct Part<'a> {
    pub(super) values: &'a [f64],
    pub(super) stride: usize,
    pub(super) rows: usize,
    pub(super) columns: usize,
}

impl<'a> Part<'a> {
    fn row(&self, row: usize) -> &'a [f64] {
        &self.values[row * self.stride..][..self.columns]
    }
}

/// Writes min over i of `a[row][i] + b[i][column]` to `into`, whose rows are `stride` numbers apart.
pub(super) fn least_sums(a: Part, b: Part, into: &mut [f64], stride: usize) {
    let mut panel = Vec::with_capacity(b.rows);
    for column in (0..b.columns).step_by(WIDTH) {
        let width = WIDTH.min(b.columns - column);
        panel.clear();
        panel.extend((0..b.rows).map(|row| padded(&b.row(row)[column..column + width])));
        for row in (0..a.rows).step_by(WIDTH) {
            let last = a.rows - 1;
            let rows = std::array::from_fn(|offset| a.row(last.min(row + offset)));
            let sums = of_rows(rows, &panel);
            for (offset, sums) in sums.iter().enumerate().take(a.rows - row) {
                let start = (row + offset) * stride + column;
                into[start..start + width].copy_from_slice(&sums.to_array()[..width]);
            }
        }
    }
}

fn padded(values: &[f64]) -> f64x4 {
    let mut four = [f64::INFINITY; WIDTH];
    four[..values.len()].copy_from_slice(values);
    f64x4::from(four)
}

fn of_rows(rows: [&[f64]; WIDTH], panel: &[f64x4]) -> [f64x4; WIDTH] {
    let mut least = [f64x4::splat(f64::INFINITY); WIDTH];
    let [a, b, c, d] = rows;
    for ((((&part, &a), &b), &c), &d) in panel.iter().zip(a).zip(b).zip(c).zip(d) {
        for (least, value) in least.iter_mut().zip([a, b, c, d]) {
            *least = least.fast_min(f64x4::splat(value) + part);
        }
    }
    least
}
