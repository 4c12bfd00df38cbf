//! Vectors laid out for speed: vectors go in, distances from one of them to a run of others come out,
//! four at a time. Each is the same to the bit as [`euclidean`] gives it.

use wide::f64x4;

use crate::feature::{FEATURE_LENGTH, Vector};

/// Vectors of a block.
const LANES: usize = 4;

/// The vectors of a set, four to a block.
#[derive(Clone, Debug, Default)]
pub struct Blocks {
    items: usize,
    blocks: Vec<[f64x4; FEATURE_LENGTH]>,
}

impl Blocks {
    /// The vectors in the order given.
    pub fn new(vectors: impl ExactSizeIterator<Item = Vector>) -> Self {
        let items = vectors.len();
        let mut blocks = Vec::with_capacity(items.div_ceil(LANES));
        let mut lanes = [[0.0; LANES]; FEATURE_LENGTH];
        for (index, vector) in vectors.enumerate() {
            let lane = index % LANES;
            for (numbers, value) in lanes.iter_mut().zip(vector) {
                numbers[lane] = value;
            }
            if lane == LANES - 1 || index == items - 1 {
                blocks.push(lanes.map(f64x4::from));
            }
        }
        Self { items, blocks }
    }

    /// Writes the distances of `vector` to the vectors from `first` on, as many as `out` holds.
    pub fn distances(&self, vector: &Vector, first: usize, out: &mut [f64]) {
        self.each(vector, first, out, |_, distance| distance);
    }

    /// The same, where a distance is smaller than what stands there.
    pub fn lessen(&self, vector: &Vector, first: usize, out: &mut [f64]) {
        self.each(vector, first, out, f64::min);
    }

    fn each(&self, vector: &Vector, first: usize, out: &mut [f64], put: impl Fn(f64, f64) -> f64) {
        let from = vector.map(f64x4::splat);
        let count = out.len().min(self.items.saturating_sub(first));
        let mut done = 0;
        while done < count {
            let place = first + done;
            let (block, lane) = (place / LANES, place % LANES);
            let values = distances(&from, &self.blocks[block]);
            let take = (LANES - lane).min(count - done);
            for (out, value) in out[done..done + take].iter_mut().zip(&values[lane..]) {
                *out = put(*out, *value);
            }
            done += take;
        }
    }
}

fn distances(from: &[f64x4; FEATURE_LENGTH], to: &[f64x4; FEATURE_LENGTH]) -> [f64; LANES] {
    let mut sum = f64x4::ZERO;
    for (a, b) in from.iter().zip(to) {
        let difference = *a - *b;
        sum += difference * difference;
    }
    sum.sqrt().to_array()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn vector(seed: usize) -> Vector {
        std::array::from_fn(|index| libm::sin((seed * 31 + index * 7) as f64))
    }

    #[test]
    fn distances_are_those_of_single_pairs_to_the_bit() {
        let vectors: Vec<Vector> = (0..11).map(vector).collect();
        let blocks = Blocks::new(vectors.iter().copied());
        for (first, count) in [(0, 11), (3, 8), (5, 2), (10, 1), (11, 0)] {
            let mut found = vec![0.0; count];
            blocks.distances(&vectors[2], first, &mut found);
            let expected = vectors[first..first + count].iter();
            let expected: Vec<f64> = expected
                .map(|other| crate::distance::euclidean(&vectors[2], other))
                .collect();
            assert_eq!(found, expected);
        }
    }
}
