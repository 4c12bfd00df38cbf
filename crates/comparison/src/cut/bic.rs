//! Vectors and their tree in; the Bayesian information criterion of every cut out.
//!
//! The model: Gaussians with one shared diagonal covariance (EEI of Banfield and Raftery 1993; Fraley
//! and Raftery 2002), fitted to the clusters of the cut as they are.

use crate::dendrogram::Dendrogram;
use crate::feature::{FEATURE_LENGTH, Vector};
use std::f64::consts::PI;

/// Components that vary less are left out.
const DROPPED_VARIANCE: f64 = 1e-24;

/// A shared variance is at least this part of the variance of all.
const LEAST_PART_OF_VARIANCE: f64 = 1e-6;

/// The criterion of the cuts into 1, 2, … ⌊n / 3⌋ clusters, of n vectors; larger is better. Beyond a
/// third of the items the criterion grows without bound.
#[must_use]
pub fn bic(vectors: &[Vector], dendrogram: &Dendrogram) -> Vec<f64> {
    let most = vectors.len() / 3;
    let mut partition = Partition::of_items(vectors);
    let variance = variance_of_all(vectors);
    let mut values = Vec::new();
    for (index, merge) in dendrogram.merges.iter().enumerate() {
        partition.merge(merge.left, merge.right);
        if vectors.len() - 1 - index <= most {
            values.push(partition.criterion(&variance));
        }
    }
    values.reverse();
    values
}

/// The number of clusters with the largest criterion, the fewest of equal ones; 1 where there is none.
#[must_use]
pub fn best(values: &[f64]) -> usize {
    let mut best = 0;
    for (index, &value) in values.iter().enumerate() {
        if value > values[best] {
            best = index;
        }
    }
    best + 1
}

/// The mean squared distance from the mean, of every component.
fn variance_of_all(vectors: &[Vector]) -> Vector {
    let count = vectors.len() as f64;
    std::array::from_fn(|k| {
        let mean = vectors.iter().map(|vector| vector[k]).sum::<f64>() / count;
        let squares = vectors
            .iter()
            .map(|vector| (vector[k] - mean) * (vector[k] - mean));
        squares.sum::<f64>() / count
    })
}

/// Clusters while they merge, numbered as the tree numbers them.
struct Partition {
    items: f64,
    clusters: usize,
    sizes: Vec<f64>,
    centroids: Vec<Vector>,
    /// Squared distances from the centroids, summed over all items.
    within: Vector,
    /// Σ n_k ln(n_k / n).
    mixing: f64,
}

impl Partition {
    fn of_items(vectors: &[Vector]) -> Self {
        let items = vectors.len() as f64;
        Self {
            items,
            clusters: vectors.len(),
            sizes: vec![1.0; vectors.len()],
            centroids: vectors.to_vec(),
            within: [0.0; FEATURE_LENGTH],
            mixing: -items * libm::log(items),
        }
    }

    fn merge(&mut self, left: usize, right: usize) {
        let (a, b) = (self.sizes[left], self.sizes[right]);
        let (one, other) = (self.centroids[left], self.centroids[right]);
        for k in 0..FEATURE_LENGTH {
            let apart = one[k] - other[k];
            self.within[k] += a * b / (a + b) * apart * apart;
        }
        self.mixing += self.mixing_of(a + b) - self.mixing_of(a) - self.mixing_of(b);
        self.sizes.push(a + b);
        let part = a / (a + b);
        self.centroids.push(std::array::from_fn(|k| {
            other[k] + (one[k] - other[k]) * part
        }));
        self.clusters -= 1;
    }

    fn mixing_of(&self, size: f64) -> f64 {
        size * libm::log(size / self.items)
    }

    /// 2 ln L − p ln n.
    fn criterion(&self, variance_of_all: &Vector) -> f64 {
        let mut dimensions = 0.0;
        let mut spread = 0.0;
        for (&within, &of_all) in self.within.iter().zip(variance_of_all) {
            if of_all > DROPPED_VARIANCE {
                let variance = (within / self.items).max(LEAST_PART_OF_VARIANCE * of_all);
                spread += self.items * libm::log(2.0 * PI * variance) + within / variance;
                dimensions += 1.0;
            }
        }
        let clusters = self.clusters as f64;
        let parameters = clusters - 1.0 + clusters * dimensions + dimensions;
        2.0 * self.mixing - spread - parameters * libm::log(self.items)
    }
}
