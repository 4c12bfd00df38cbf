//! Distances of all pairs of `items` things, as SciPy keeps them: in a row for every thing, only the
//! pairs with a later one.

mod keeping;

pub(crate) use keeping::Keeping;

use crate::distance::euclidean;
use crate::feature::{FEATURE_LENGTH, Vector};
use std::array;
use std::ops::Range;
use wide::f64x4;

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

/// How many pairs so many things have. No step on the way is larger than the pairs.
#[must_use]
pub fn pairs(items: usize) -> usize {
    match items % 2 {
        0 => items / 2 * items.saturating_sub(1),
        _ => items * (items / 2),
    }
}

/// All pairs need more memory than there is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooManyPairs {
    /// Of how many things.
    pub items: usize,
    /// The memory that they need.
    pub bytes: u64,
}

impl Condensed {
    /// A matrix without values, with room for all: in the memory of an earlier one, if that suffices.
    ///
    /// # Errors
    /// [`TooManyPairs`].
    pub fn with_room(items: usize, room: Vec<f64>) -> Result<Self, TooManyPairs> {
        let pairs = items as u64 * items.saturating_sub(1) as u64 / 2;
        let mut values = room;
        values.clear();
        if (values.capacity() as u64) < pairs {
            // It goes first: to let it grow would need both at once.
            values = Vec::new();
        }
        let reserved = usize::try_from(pairs).map(|pairs| values.try_reserve_exact(pairs));
        match reserved {
            Ok(Ok(())) => Ok(Self { items, values }),
            _ => Err(TooManyPairs {
                items,
                bytes: pairs.saturating_mul(size_of::<f64>() as u64),
            }),
        }
    }

    /// The matrix of `value(row, column)`, asked once for every `row < column`.
    pub fn from_fn(items: usize, mut value: impl FnMut(usize, usize) -> f64) -> Self {
        let mut values = Vec::with_capacity(pairs(items));
        for row in 0..items {
            for column in row + 1..items {
                values.push(value(row, column));
            }
        }
        Self { items, values }
    }

    /// The Euclidean distances of vectors, as [`crate::distance::euclidean`] finds each.
    #[must_use]
    pub fn of_vectors(vectors: &[Vector]) -> Self {
        let items = vectors.len();
        let components: [Vec<f64>; FEATURE_LENGTH] =
            array::from_fn(|k| vectors.iter().map(|vector| vector[k]).collect());
        let mut values = Vec::with_capacity(pairs(items));
        for (row, vector) in vectors.iter().enumerate() {
            let mut column = row + 1;
            while column + 4 <= items {
                values.extend(four_distances(vector, &components, column));
                column += 4;
            }
            values.extend(
                vectors[column.min(items)..]
                    .iter()
                    .map(|other| euclidean(vector, other)),
            );
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
}

/// The distances of a vector from the four that begin at `column`.
fn four_distances(
    vector: &Vector,
    components: &[Vec<f64>; FEATURE_LENGTH],
    column: usize,
) -> [f64; 4] {
    let mut sum = f64x4::splat(0.0);
    for (&value, others) in vector.iter().zip(components) {
        let four: [f64; 4] = array::from_fn(|lane| others[column + lane]);
        let apart = f64x4::splat(value) - f64x4::from(four);
        sum += apart * apart;
    }
    sum.sqrt().to_array()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_by_hand() {
        assert_eq!([0, 1, 2, 3, 4, 5].map(pairs), [0, 0, 1, 3, 6, 10]);
        // Twice as many would not fit.
        let many = 1 << (usize::BITS / 2);
        assert_eq!(pairs(many), usize::MAX / 2 + 1 - many / 2);
    }

    #[test]
    fn more_than_there_is_memory_for_is_said() {
        let items = 1_000_000_000;
        let refused = Condensed::with_room(items, Vec::new()).expect_err("an exabyte");
        let bytes = 4 * items as u64 * (items as u64 - 1);
        assert_eq!((refused.items, refused.bytes), (items, bytes));
        let matrix = Condensed::with_room(5, vec![1.0; 3]).expect("room");
        assert_eq!((matrix.items, matrix.values.capacity()), (5, 10));
    }

    #[test]
    fn the_memory_of_a_larger_matrix_is_taken() {
        let room = vec![1.0; 10];
        let place = room.as_ptr();
        let matrix = Condensed::with_room(4, room).expect("room");
        assert_eq!((matrix.values.as_ptr(), matrix.values.len()), (place, 0));
    }
}
