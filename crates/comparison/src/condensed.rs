//! Distances of all pairs of `items` things, as SciPy keeps them: in a row for every thing, only the
//! pairs with a later one.

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

    /// The value of two different things in either order, to be changed.
    pub(crate) fn at_mut(&mut self, one: usize, other: usize) -> &mut f64 {
        let (row, column) = (one.min(other), one.max(other));
        &mut self.values[index(self.items, row, column)]
    }
}
