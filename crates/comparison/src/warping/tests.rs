//! Warping against a plain table, and cases by hand.

use super::*;
use crate::feature::JOINTS;
use test_support::Random;

const WIDTH: usize = 3 * JOINTS;

/// A motion of all joints along x, frame by frame.
fn along_x(places: &[f64]) -> Vec<f64> {
    let posture = |place: &f64| {
        core::array::from_fn::<f64, WIDTH, _>(|index| if index % 3 == 0 { *place } else { 0.0 })
    };
    places.iter().flat_map(posture).collect()
}

/// A slow random motion.
fn wandering(frames: usize, seed: u64) -> Vec<f64> {
    let mut random = Random::new(seed);
    let mut posture = [0.0; WIDTH];
    let mut next = || {
        for value in &mut posture {
            *value += 0.2 * (random.unit() - 0.5);
        }
        posture
    };
    (0..frames).flat_map(|_| next()).collect()
}

fn warped(a: &[f64], b: &[f64], band: Option<usize>) -> Warped {
    Warping::new(a, b, band).expect("a warping").finish()
}

/// The definition: a full table.
fn plain(a: &[f64], b: &[f64], band: Option<usize>) -> (f64, Vec<(usize, usize)>) {
    let (a, b) = (split(a), split(b));
    let slope = (b.len() as f64 - 1.0) / (a.len() as f64 - 1.0);
    let is_inside = |i: usize, j: usize| match band {
        Some(width) if a.len() > 1 => {
            (j as f64 - i as f64 * slope).abs() <= (width as f64).max(slope).max(1.0) + 1e-9
        }
        _ => true,
    };
    let mut table = vec![vec![(f64::INFINITY, (0, 0)); b.len()]; a.len()];
    for i in 0..a.len() {
        for j in 0..b.len() {
            if !is_inside(i, j) {
                continue;
            }
            let sum = joint_distances(&a[i], &b[j])
                .iter()
                .fold(0.0, |sum, value| sum + value);
            let d = sum / 16.0;
            let mut ways = Vec::new();
            if i > 0 && j > 0 {
                ways.push((table[i - 1][j - 1].0 + 2.0 * d, (i - 1, j - 1)));
            }
            if i > 0 {
                ways.push((table[i - 1][j].0 + d, (i - 1, j)));
            }
            if j > 0 {
                ways.push((table[i][j - 1].0 + d, (i, j - 1)));
            }
            table[i][j] = (2.0 * d, (0, 0));
            if !ways.is_empty() {
                table[i][j] = ways.iter().fold(
                    ways[0],
                    |best, way| if way.0 < best.0 { *way } else { best },
                );
            }
        }
    }
    let mut path = vec![(a.len() - 1, b.len() - 1)];
    while let Some(&(i, j)) = path.last()
        && (i, j) != (0, 0)
    {
        path.push(table[i][j].1);
    }
    path.reverse();
    (
        table[a.len() - 1][b.len() - 1].0 / (a.len() + b.len()) as f64,
        path,
    )
}

#[test]
fn distance_and_path_are_those_of_the_plain_table() {
    let sizes = [
        (1, 1),
        (1, 7),
        (6, 1),
        (2, 3),
        (9, 9),
        (33, 20),
        (17, 70),
        (64, 65),
        // So wide that fewer rows are made at once.
        (10, 40_000),
    ];
    for (place, (n, m)) in sizes.into_iter().enumerate() {
        let (a, b) = (wandering(n, place as u64), wandering(m, 50 + place as u64));
        for band in [None, Some(0), Some(3), Some(10), Some(1000)] {
            let found = warped(&a, &b, band);
            let (distance, path) = plain(&a, &b, band);
            assert_eq!(found.distance, distance, "{n} {m} {band:?}");
            let found: Vec<_> = found.path_a.into_iter().zip(found.path_b).collect();
            assert_eq!(found, path, "{n} {m} {band:?}");
        }
    }
}

#[test]
fn a_budget_does_not_change_the_result() {
    let (a, b) = (wandering(90, 1), wandering(70, 2));
    let mut warping = Warping::new(&a, &b, Some(20)).expect("a warping");
    let mut last = 0.0;
    let mut steps = 0;
    while last < 1.0 {
        let done = warping.step(1);
        assert!(done > last);
        (last, steps) = (done, steps + 1);
    }
    assert!(steps > 10);
    assert_eq!(warping.finish(), warped(&a, &b, Some(20)));
}

#[test]
fn by_hand() {
    // 0 3 3 against 0 3: the second clip waits at its end, at no cost.
    let found = warped(&along_x(&[0.0, 3.0, 3.0]), &along_x(&[0.0, 3.0]), None);
    assert_eq!(found.distance, 0.0);
    assert_eq!(found.path_a, [0, 1, 2]);
    assert_eq!(found.path_b, [0, 1, 1]);
    assert_eq!(found.ahead, [0.0, 0.5, 0.0]);
    // 0 1 against 2 2: 2·2, then 2·1 diagonally; of the same cost as along a side.
    let found = warped(&along_x(&[0.0, 1.0]), &along_x(&[2.0, 2.0]), None);
    assert_eq!(found.distance, (4.0 + 2.0) / 4.0);
    assert_eq!((found.path_a, found.path_b), (vec![0, 1], vec![0, 1]));
    assert_eq!(found.part_distances, [[2.0; PARTS], [1.0; PARTS]]);
    // One frame against three: 2·1, then 2 and 3.
    let found = warped(&along_x(&[0.0]), &along_x(&[1.0, 2.0, 3.0]), Some(1));
    assert_eq!(found.distance, (2.0 + 2.0 + 3.0) / 4.0);
    assert_eq!(found.ahead, [0.0, 0.5, 1.0]);
}

#[test]
fn the_distance_is_symmetric_and_that_of_mirror_images() {
    let (a, b) = (wandering(40, 8), wandering(55, 9));
    let distance = warped(&a, &b, None).distance;
    assert!((warped(&b, &a, None).distance - distance).abs() < 1e-14);
    let mirrored = warped(&mirror_postures(&a), &mirror_postures(&b), None);
    assert!((mirrored.distance - distance).abs() < 1e-14);
    assert_eq!(warped(&a, &a, None).distance, 0.0);
}

#[test]
fn parts_are_told_apart() {
    let a = vec![0.0; WIDTH];
    let mut b = a.clone();
    // Left wrist (joint 2) and right toe (joint 13).
    (b[6], b[8], b[40]) = (3.0, 4.0, 6.0);
    let found = warped(&a, &b, None);
    assert_eq!(found.part_distances, [[5.0 / 4.0, 0.0, 0.0, 2.0, 0.0]]);
    assert_eq!(found.distance, (5.0 + 6.0) / 16.0);
    assert_eq!(found.full_colour, 5.0 / 4.0);
}

#[test]
fn what_cannot_be_warped_says_why() {
    let one = vec![0.0; WIDTH];
    assert_eq!(
        Warping::new(&[], &one, None).err(),
        Some(WarpingError::NoFrames)
    );
    assert_eq!(
        Warping::new(&one, &[1.0; 47], None).err(),
        Some(WarpingError::NoFrames)
    );
    let long = vec![0.0; WIDTH * 16_400];
    let cells = 16_400 * 16_400;
    let error = WarpingError::TooManyCells {
        cells,
        most: MOST_CELLS,
    };
    assert_eq!(Warping::new(&long, &long, None).err(), Some(error));
    assert!(Warping::new(&long, &long, Some(100)).is_ok());
}

#[test]
fn numbers_that_are_none_end_all_the_same() {
    let mut a = wandering(20, 4);
    a[700] = f64::NAN;
    let found = warped(&a, &wandering(30, 5), Some(4));
    assert_eq!((found.path_a[0], found.path_b[0]), (0, 0));
}

#[test]
fn the_quantile_is_that_of_the_sorted_values() {
    let values: Vec<f64> = (0..=1000).rev().map(f64::from).collect();
    assert_eq!(quantile(values, FULL_COLOUR), 985.0);
    assert_eq!(quantile(vec![], FULL_COLOUR), 0.0);
}
