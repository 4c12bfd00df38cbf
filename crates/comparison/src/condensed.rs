//! Distances of all pairs of `items` things, as SciPy keeps them: in a row for every thing, only the
//! pairs with a later one.

use std::ops::Range;

/// The upper triangle of a symmetric matrix without its diagonal, row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct Condensed {
    /// How many things there are.
    pub items: usize,
    /// The `items · (items − 1) / 2` values: (0,1), (0,2), …, (1,2), …
    pub values: Vec<f64>,
}

/// Where the pair (`row`, `column`) stands, for `row < column < items`.
#[must_use]
pub fn index(items: usize, row: usize, column: usize) -> usize {
    row * (2 * items - row - 1) / 2 + column - row - 1
}

impl Condensed {
    /// The matrix of `value(row, column)`, asked once for every `row < column`.
    pub fn from_fn(items: usize, mut value: impl FnMut(usize, usize) -> f64) -> Self {
        let mut values = Vec::with_capacity(items * items.saturating_sub(1) / 2);
        for row in 0..items {
            for column in row + 1..items {
                values.push(value(row, column));
            }
        }
        Self { items, values }
    }

    /// The value of a pair in either order; 0 for a thing and itself.
    #[must_use]
    pub fn at(&self, one: usize, other: usize) -> f64 {
        match one.cmp(&other) {
            std::cmp::Ordering::Less => self.values[index(self.items, one, other)],
            std::cmp::Ordering::Greater => self.values[index(self.items, other, one)],
            std::cmp::Ordering::Equal => 0.0,
        }
    }

    /// Where the values of a thing with those before it stand, in order.
    pub(crate) fn column(&self, item: usize) -> impl Iterator<Item = usize> + use<> {
        let items = self.items;
        let mut next = item.wrapping_sub(1);
        (0..item).map(move |row| {
            let place = next;
            next = next.wrapping_add(items - row - 2);
            place
        })
    }

    /// Where the values of a thing with those after it stand.
    pub(crate) fn row(&self, item: usize) -> Range<usize> {
        let start = item * (2 * self.items - item - 1) / 2;
        start..start + self.items - item - 1
    }

    /// Leaves only the things `kept`, which rise.
    pub(crate) fn keep(&mut self, kept: &[usize]) {
        let mut place = 0;
        for (at, &row) in kept.iter().enumerate() {
            let start = self.row(row).start;
            for &column in &kept[at + 1..] {
                self.values[place] = self.values[start + column - row - 1];
                place += 1;
            }
        }
        self.values.truncate(place);
        self.items = kept.len();
    }
}
