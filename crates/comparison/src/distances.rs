//! Distances between all items of a set: features go in; one distance, or those of a row, come out.
//! Where a distance is that of vectors it is computed when asked for, and nothing is stored.

use crate::blocks::Blocks;
use crate::condensed::{self, Condensed};
use crate::distance::euclidean;
use crate::feature::Vector;

/// The distances of a set.
#[derive(Clone, Debug)]
pub enum Distances {
    /// Those of vectors.
    OfVectors(VectorDistances),
    /// Any, one number for each pair.
    Stored(Condensed),
}

/// Vectors as they are, and laid out for speed.
#[derive(Clone, Debug)]
pub struct VectorDistances {
    vectors: Vec<Vector>,
    blocks: Blocks,
}

impl Distances {
    /// The Euclidean distances of vectors.
    pub fn of_vectors(vectors: Vec<Vector>) -> Self {
        let blocks = Blocks::new(vectors.iter().copied());
        Self::OfVectors(VectorDistances { vectors, blocks })
    }

    /// How many items there are.
    pub fn items(&self) -> usize {
        match self {
            Self::OfVectors(of) => of.vectors.len(),
            Self::Stored(matrix) => matrix.items,
        }
    }

    /// How many pairs there are.
    pub fn pairs(&self) -> usize {
        self.items() * self.items().saturating_sub(1) / 2
    }

    /// The vectors, where there are any.
    pub fn vectors(&self) -> Option<&[Vector]> {
        match self {
            Self::OfVectors(of) => Some(&of.vectors),
            Self::Stored(_) => None,
        }
    }

    /// The distance of two items.
    pub fn at(&self, a: usize, b: usize) -> f64 {
        match self {
            Self::OfVectors(of) => euclidean(&of.vectors[a], &of.vectors[b]),
            Self::Stored(matrix) => matrix.at(a, b),
        }
    }

    /// The distances of `item` to all later ones.
    pub fn to_later(&self, item: usize) -> Vec<f64> {
        let later = self.items() - item - 1;
        match self {
            Self::OfVectors(of) => {
                let mut row = vec![0.0; later];
                of.blocks.distances(&of.vectors[item], item + 1, &mut row);
                row
            }
            Self::Stored(_) if later == 0 => Vec::new(),
            Self::Stored(matrix) => {
                let start = condensed::index(matrix.items, item, item + 1);
                matrix.values[start..start + later].to_vec()
            }
        }
    }

    /// The distances of `item` to all items, 0 to itself.
    pub fn row(&self, item: usize) -> Vec<f64> {
        match self {
            Self::OfVectors(of) => {
                let mut row = vec![0.0; of.vectors.len()];
                of.blocks.distances(&of.vectors[item], 0, &mut row);
                row
            }
            Self::Stored(matrix) => (0..matrix.items)
                .map(|other| self.at(item, other))
                .collect(),
        }
    }

    /// Some items as the columns of many rows.
    pub fn columns(&self, items: &[usize]) -> Columns {
        let vectors = match self {
            Self::OfVectors(of) => &of.vectors[..],
            Self::Stored(_) => &[],
        };
        let blocks = match vectors {
            [] => Blocks::default(),
            _ => Blocks::new(items.iter().map(|item| vectors[*item])),
        };
        Columns {
            items: items.to_vec(),
            blocks,
        }
    }

    /// All of them in SciPy's order.
    pub fn condensed(&self) -> Vec<f64> {
        match self {
            Self::OfVectors(_) => (0..self.items())
                .flat_map(|item| self.to_later(item))
                .collect(),
            Self::Stored(matrix) => matrix.values.clone(),
        }
    }
}

/// Items in an order of their own.
#[derive(Clone, Debug)]
pub struct Columns {
    items: Vec<usize>,
    /// Their vectors, where there are any.
    blocks: Blocks,
}

impl Columns {
    /// Writes the distances of `item` to the columns from `first` on, as many as `out` holds.
    pub fn distances(&self, distances: &Distances, item: usize, first: usize, out: &mut [f64]) {
        match distances {
            Distances::OfVectors(of) => self.blocks.distances(&of.vectors[item], first, out),
            Distances::Stored(matrix) => {
                for (value, other) in out.iter_mut().zip(&self.items[first..]) {
                    *value = matrix.at(item, *other);
                }
            }
        }
    }
}
