//! Vectors in; the order of their components out that tells far ones apart soonest.

use crate::feature::{FEATURE_LENGTH, Vector};
use std::ops::Range;

/// The components in parts: after each of them what is already too far is left.
pub(super) const PARTS: [Range<usize>; 2] = [0..4, 4..FEATURE_LENGTH];

/// The components, that of the largest variance first. Distances do not depend on the order.
pub(super) fn widest_first(vectors: &[Vector]) -> [usize; FEATURE_LENGTH] {
    let count = vectors.len() as f64;
    let variances: Vector = std::array::from_fn(|k| {
        let mean = vectors.iter().map(|vector| vector[k]).sum::<f64>() / count;
        let apart = vectors.iter().map(|vector| vector[k] - mean);
        apart.map(|apart| apart * apart).sum()
    });
    let mut order = std::array::from_fn(|k| k);
    order.sort_by(|&a: &usize, &b: &usize| variances[b].total_cmp(&variances[a]));
    order
}
