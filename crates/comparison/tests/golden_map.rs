//! The map of real clips against an independent implementation's classical scaling.

mod support;

use comparison::condensed::Condensed;
use comparison::map::{Map, of_matrix, of_vectors};
use support::{golden, is_close, numbers, vectors};

#[test]
fn spread_and_eigenvalues_are_those_of_the_reference() {
    let Some(golden) = golden() else { return };
    let vectors = vectors(&golden["features"]);
    let matrix = Condensed {
        items: vectors.len(),
        values: numbers(&golden["condensed"]),
    };
    let expected = &golden["classical_scaling"];
    let share = expected["share_of_spread"].as_f64().expect("a number");
    for map in [of_vectors(&vectors), of_matrix(&matrix)] {
        let values = numbers(&expected["eigenvalues"]);
        for (axis, expected) in values.iter().enumerate() {
            let found = squares_along(&map, axis);
            assert!(is_close(found, *expected, 1e-9), "{found} {expected}");
        }
        assert!(is_close(map.spread, share, 1e-9), "{} {share}", map.spread);
    }
}

/// The eigenvalue of an axis is the sum of its squared coordinates.
fn squares_along(map: &Map, axis: usize) -> f64 {
    map.places
        .iter()
        .map(|place| place[axis] * place[axis])
        .sum()
}
