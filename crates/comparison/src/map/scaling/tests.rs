//! Maps of known points, and both ways of making one against each other.

use super::*;
use crate::condensed::Condensed;
use crate::distance::euclidean;
use crate::map::{MatrixMapSteps, of_matrix};
use test_support::Random;

/// Vectors whose numbers spread less and less.
fn vectors(count: usize) -> Vec<Vector> {
    let mut random = Random::new(5);
    let scale = |index: usize| 1.0 / (1.0 + index as f64);
    let mut vector = || core::array::from_fn(|index| 3.0 + scale(index) * random.unit());
    (0..count).map(|_| vector()).collect()
}

fn matrix(vectors: &[Vector]) -> Condensed {
    Condensed::from_fn(vectors.len(), |one, other| {
        euclidean(&vectors[one], &vectors[other])
    })
}

fn assert_same(one: &Map, other: &Map, tolerance: f64) {
    for (one, other) in one.places.iter().zip(&other.places) {
        let difference = (one[0] - other[0]).abs().max((one[1] - other[1]).abs());
        assert!(difference < tolerance, "{one:?} {other:?}");
    }
    let squares = one
        .squares_from_middle
        .iter()
        .zip(&other.squares_from_middle);
    for (one, other) in squares {
        assert!((one - other).abs() < tolerance);
    }
}

#[test]
fn a_rectangle_lies_along_its_sides() {
    let corner = |x: f64, y: f64| {
        let mut vector = [0.5; FEATURE_LENGTH];
        (vector[2], vector[9]) = (x, y);
        vector
    };
    let corners = [
        corner(0.0, 0.0),
        corner(1.0, 4.0),
        corner(1.0, 0.0),
        corner(0.0, 4.0),
    ];
    for map in [of_vectors(&corners), of_matrix(&matrix(&corners))] {
        assert!((map.spread - 1.0).abs() < 1e-14);
        for (place, square) in map.places.iter().zip(&map.squares_from_middle) {
            assert!((place[0].abs() - 2.0).abs() < 1e-14, "{map:?}");
            assert!((place[1].abs() - 0.5).abs() < 1e-14);
            assert!((square - 4.25).abs() < 1e-14);
        }
        // 0 and 2, and 0 and 3, are neighbours along the sides.
        assert!((map.places[0][0] - map.places[2][0]).abs() < 1e-14);
        assert!((map.places[0][1] - map.places[3][1]).abs() < 1e-14);
    }
}

#[test]
fn both_ways_give_the_same_map() {
    let vectors = vectors(60);
    let (one, other) = (of_vectors(&vectors), of_matrix(&matrix(&vectors)));
    assert_same(&one, &other, 1e-12);
    assert!((one.spread - other.spread).abs() < 1e-12);
}

#[test]
fn above_the_exact_size_the_places_are_the_same_and_the_spread_is_near() {
    let vectors = vectors(450);
    let (one, other) = (of_vectors(&vectors), of_matrix(&matrix(&vectors)));
    assert_same(&one, &other, 1e-11);
    assert!(
        (one.spread - other.spread).abs() < 1e-9,
        "{} {}",
        one.spread,
        other.spread
    );
}

#[test]
fn the_largest_coordinate_of_each_axis_is_positive() {
    let map = of_vectors(&vectors(31));
    for axis in 0..2 {
        let by_size = |one: &&Place, other: &&Place| one[axis].abs().total_cmp(&other[axis].abs());
        assert!(map.places.iter().max_by(by_size).expect("a place")[axis] > 0.0);
    }
}

#[test]
fn distances_of_no_space_have_only_their_positive_part_counted() {
    // Four in a ring whose opposite ones are too far: B has a negative eigenvalue.
    let matrix = Condensed {
        items: 4,
        values: vec![1.0, 3.0, 1.0, 1.0, 3.0, 1.0],
    };
    let map = of_matrix(&matrix);
    assert!((map.spread - 1.0).abs() < 1e-12, "{}", map.spread);
}

#[test]
fn few_and_equal_items_have_a_map() {
    assert!(of_vectors(&[]).places.is_empty());
    assert!(of_matrix(&matrix(&[])).places.is_empty());
    for count in [1, 2, 5] {
        let same = vec![[0.25; FEATURE_LENGTH]; count];
        for map in [of_vectors(&same), of_matrix(&matrix(&same))] {
            assert_eq!(map.places, vec![[0.0; 2]; count]);
            assert_eq!(map.spread, 1.0);
        }
    }
    let two = vectors(2);
    let distance = euclidean(&two[0], &two[1]);
    for map in [of_vectors(&two), of_matrix(&matrix(&two))] {
        let found = map.places[0][0] - map.places[1][0];
        assert!((found.abs() - distance).abs() < 1e-14);
        assert!(map.places[0][1].abs() < 1e-8);
    }
}

#[test]
fn a_map_in_pieces_is_the_same() {
    for count in [0, 1, 2, 40, 320] {
        let matrix = matrix(&vectors(count));
        let mut steps = MatrixMapSteps::new(&matrix);
        let mut done = 0.0;
        while done < 1.0 {
            let now = steps.step(&matrix, 1_000);
            assert!((done..=1.0).contains(&now), "{count}: {done} then {now}");
            done = now;
        }
        assert_eq!(steps.finish(&matrix), of_matrix(&matrix));
    }
}

/// Both lie as far from their middle; which one rounding puts farther does not matter.
#[test]
fn of_two_the_first_lies_on_the_positive_side() {
    let mut random = Random::new(11);
    for _ in 0..50 {
        let vectors: [Vector; 2] =
            core::array::from_fn(|_| core::array::from_fn(|_| random.unit()));
        for map in [of_vectors(&vectors), of_matrix(&matrix(&vectors))] {
            assert!(map.places[0][0] > 0.0, "{:?}", map.places);
        }
    }
}

/// Mirror-aware distances have negative eigenvalues: how much they weigh is estimated.
#[test]
fn the_spread_of_many_by_a_distance_without_vectors_is_near() {
    let vectors = vectors(420);
    let distance = |one: usize, other: usize| {
        let (one, other) = (&vectors[one], &vectors[other]);
        euclidean(one, other).min(euclidean(one, &crate::distance::mirror(other)))
    };
    let matrix = Condensed::from_fn(vectors.len(), distance);
    let found = of_matrix(&matrix).spread;
    let exact = spread(&centred_eigenvalues(&matrix));
    assert!((found - exact).abs() < 2e-3, "{found} {exact}");
}

/// All eigenvalues of −½ J D² J.
fn centred_eigenvalues(matrix: &Condensed) -> Vec<f64> {
    let items = matrix.items;
    let centred = |values: &[f64]| {
        let mean = values.iter().sum::<f64>() / items as f64;
        values.iter().map(|value| value - mean).collect::<Vec<_>>()
    };
    let square = |one: usize, other: usize| match one == other {
        true => 0.0,
        false => matrix.at(one, other) * matrix.at(one, other),
    };
    let squares: Vec<Vec<f64>> = (0..items)
        .map(|one| (0..items).map(|other| square(one, other)).collect())
        .collect();
    let apply = |from: &[f64], to: &mut [f64]| {
        let from = centred(from);
        let products: Vec<f64> = squares.iter().map(|row| dot(row, &from)).collect();
        for (value, product) in to.iter_mut().zip(centred(&products)) {
            *value = -0.5 * product;
        }
    };
    spectrum(items, items, apply).values
}
