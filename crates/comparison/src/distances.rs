//! Distances between all items of a set: features go in; one distance, or those of a row, come out.
//! They are computed when asked for, and nothing is stored: ten thousand items have fifty million pairs.

use core::borrow::Borrow;

use crate::blocks::Blocks;
use crate::condensed;
use crate::distance::{Distance, euclidean, mirror};
use crate::feature::{ClipFeature, Vector};

/// The distances of a set: vectors as they are, and laid out for speed.
#[derive(Clone, Debug)]
pub struct Distances {
    vectors: Vec<Vector>,
    blocks: Blocks,
    is_mirror_aware: bool,
}

impl Distances {
    /// Those of clips.
    pub fn of(distance: Distance, clips: &[impl Borrow<ClipFeature>]) -> Self {
        let vectors = clips.iter().map(|clip| *distance.vector(clip.borrow()));
        Self::of_vectors(vectors.collect(), distance.choice().mirror_aware)
    }

    /// The Euclidean distances of vectors; where `is_mirror_aware`, those to the nearer of the other
    /// vector and its mirror image.
    pub fn of_vectors(vectors: Vec<Vector>, is_mirror_aware: bool) -> Self {
        Self {
            blocks: Blocks::new(vectors.iter().copied()),
            vectors,
            is_mirror_aware,
        }
    }

    /// How many items there are.
    pub fn items(&self) -> usize {
        self.vectors.len()
    }

    /// How many pairs there are.
    pub fn pairs(&self) -> usize {
        condensed::pairs(self.items())
    }

    /// The part of all pairs that the first `rows` rows hold, each with the later items; 1 of none.
    pub(crate) fn part_of_rows(&self, rows: usize) -> f64 {
        let (all, left) = (self.pairs(), condensed::pairs(self.items() - rows));
        match all {
            0 => 1.0,
            _ => (all - left) as f64 / all as f64,
        }
    }

    /// The vectors whose Euclidean distances they are; none where mirror images count.
    pub fn vectors(&self) -> Option<&[Vector]> {
        (!self.is_mirror_aware).then_some(&self.vectors)
    }

    /// The distance of two items.
    pub fn at(&self, a: usize, b: usize) -> f64 {
        let (a, b) = (&self.vectors[a], &self.vectors[b]);
        let straight = euclidean(a, b);
        match self.is_mirror_aware {
            true => straight.min(euclidean(&mirror(a), b)),
            false => straight,
        }
    }

    /// The distances of `item` to all later ones.
    pub fn to_later(&self, item: usize) -> Vec<f64> {
        let mut row = vec![0.0; self.items() - item - 1];
        self.write(&self.blocks, &self.vectors[item], item + 1, &mut row);
        row
    }

    /// The distances of `item` to all items; that to itself is 0.
    pub fn row(&self, item: usize) -> Vec<f64> {
        self.from_vector(&self.vectors[item])
    }

    /// The distances of a vector, of an item or of something else, to all items.
    pub fn from_vector(&self, vector: &Vector) -> Vec<f64> {
        let mut row = vec![0.0; self.items()];
        self.write(&self.blocks, vector, 0, &mut row);
        row
    }

    /// Some items as the columns of many rows.
    pub fn columns(&self, items: &[usize]) -> Columns {
        Columns {
            blocks: Blocks::new(items.iter().map(|item| self.vectors[*item])),
        }
    }

    /// All of them in SciPy's order.
    pub fn condensed(&self) -> Vec<f64> {
        let rows = 0..self.items();
        rows.flat_map(|item| self.to_later(item)).collect()
    }

    /// Writes the distances of a vector to others from `first` on, as many as `out` holds.
    fn write(&self, to: &Blocks, vector: &Vector, first: usize, out: &mut [f64]) {
        to.distances(vector, first, out);
        if self.is_mirror_aware {
            to.lessen(&mirror(vector), first, out);
        }
    }
}

/// Items in an order of their own.
#[derive(Clone, Debug)]
pub struct Columns {
    blocks: Blocks,
}

impl Columns {
    /// Writes the distances of `item` to the columns from `first` on, as many as `out` holds.
    pub fn distances(&self, distances: &Distances, item: usize, first: usize, out: &mut [f64]) {
        distances.write(&self.blocks, &distances.vectors[item], first, out);
    }
}

#[cfg(test)]
impl Distances {
    /// Those of points on a line.
    pub(crate) fn on_a_line(places: &[f64]) -> Self {
        let vector =
            |place: &f64| -> Vector { std::array::from_fn(|k| if k == 7 { *place } else { 0.0 }) };
        Self::of_vectors(places.iter().map(vector).collect(), false)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::distance::Dissimilarity;
    use crate::feature::{FEATURE_LENGTH, JOINTS};

    fn clip(item: usize) -> ClipFeature {
        let number = |k: usize| libm::sin((item * 31 + k * 7) as f64);
        ClipFeature {
            recorded: std::array::from_fn(number),
            across_rigs: [0.0; FEATURE_LENGTH],
            recorded_by_joint: [[0.0; FEATURE_LENGTH]; JOINTS],
            across_rigs_by_joint: [[0.0; FEATURE_LENGTH]; JOINTS],
        }
    }

    /// To the bit, since a tree may hang on it.
    #[test]
    fn they_are_those_of_single_pairs() {
        let clips: Vec<ClipFeature> = (0..11).map(clip).collect();
        for mirror_aware in [false, true] {
            let distance = Distance::PostureVariation(Dissimilarity {
                across_rigs: false,
                mirror_aware,
            });
            let found = Distances::of(distance, &clips);
            let expected = |a: usize, b: usize| distance.between(&clips[a], &clips[b]).value;
            let columns = found.columns(&[9, 2, 10, 5, 6, 0]);
            for item in 0..11 {
                let row: Vec<f64> = (0..11).map(|other| expected(item, other)).collect();
                assert_eq!(found.row(item), row);
                assert_eq!(found.to_later(item), row[item + 1..]);
                assert_eq!(found.at(item, 7), row[7]);
                let mut some = [0.0; 3];
                columns.distances(&found, item, 2, &mut some);
                assert_eq!(some, [row[10], row[5], row[6]]);
            }
        }
    }

    #[test]
    fn parts_of_the_pairs_by_hand() {
        let of = |items: usize| Distances::of_vectors(vec![[0.0; FEATURE_LENGTH]; items], false);
        let four = of(4);
        let parts: Vec<f64> = (0..5).map(|rows| four.part_of_rows(rows)).collect();
        assert_eq!(parts, [0.0, 0.5, 5.0 / 6.0, 1.0, 1.0]);
        assert_eq!((of(1).part_of_rows(0), of(0).part_of_rows(0)), (1.0, 1.0));
    }
}
