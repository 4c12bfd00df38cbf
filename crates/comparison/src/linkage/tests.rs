//! The walk over centroids against the one over the matrix, where both can go.

use super::{Chain, OnCentroids, OnMatrix, WardRule};
use crate::condensed::Condensed;
use crate::dendrogram::Dendrogram;
use crate::feature::Vector;
use proptest::prelude::*;

fn on_matrix(vectors: &[Vector]) -> Dendrogram {
    let condensed = Condensed::of_vectors(vectors);
    Chain::of(OnMatrix::<WardRule>::of(condensed)).finish()
}

fn assert_same_on_centroids(vectors: &[Vector]) {
    let found = Chain::of(OnCentroids::of(vectors)).finish();
    let expected = on_matrix(vectors);
    assert_eq!(found.merges.len(), expected.merges.len());
    for (found, expected) in found.merges.iter().zip(&expected.merges) {
        assert_eq!((found.left, found.right), (expected.left, expected.right));
        let apart = (found.height - expected.height).abs();
        assert!(apart <= 1e-9 * expected.height, "{found:?} {expected:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(80))]

    #[test]
    fn spread_vectors(vectors in prop::collection::vec(prop::array::uniform12(-1.0..1.0_f64), 1..300)) {
        assert_same_on_centroids(&vectors);
    }

    /// As real features: few directions, and of very different size.
    #[test]
    fn flat_vectors(points in prop::collection::vec(prop::array::uniform3(-1.0..1.0_f64), 1..400)) {
        let vector = |&[x, y, z]: &[f64; 3]| -> Vector {
            std::array::from_fn(|k| [x, 0.1 * y, 0.01 * z][k % 3] * (1.0 + k as f64))
        };
        assert_same_on_centroids(&points.iter().map(vector).collect::<Vec<_>>());
    }

    /// Copies: ties that do not hang on rounding.
    #[test]
    fn copies(
        originals in prop::collection::vec(prop::array::uniform12(-1.0..1.0_f64), 40),
        picks in prop::collection::vec(0..40_usize, 2..200),
    ) {
        let vectors: Vec<Vector> = picks.iter().map(|&pick| originals[pick]).collect();
        assert_same_on_centroids(&vectors);
    }
}
