//! The sweep against the plain table, ties included.

use super::partners;
use crate::keypose::candidates::minima;
use crate::test_random::Random;

/// The plain table: the least (Σ |Δt|, Σ partner index) over all order-preserving assignments.
fn partners_by_table(smaller: &[usize], larger: &[usize]) -> Vec<usize> {
    let (rows, columns) = (smaller.len(), larger.len());
    let dear = (i64::MAX / 4, 0);
    let mut table = vec![vec![(0, 0); columns + 1]; rows + 1];
    for row in 1..=rows {
        table[row][row - 1] = dear;
        for column in row..=columns {
            let cost = smaller[row - 1].abs_diff(larger[column - 1]) as i64;
            let before: (i64, i64) = table[row - 1][column - 1];
            let taken = (before.0 + cost, before.1 + column as i64 - 1);
            table[row][column] = taken.min(table[row][column - 1]);
        }
    }
    let mut column = columns;
    let mut found = Vec::new();
    for row in (1..=rows).rev() {
        while column > row && table[row][column] == table[row][column - 1] {
            column -= 1;
        }
        found.push(column - 1);
        column -= 1;
    }
    found.reverse();
    found
}

fn ascending(random: &mut Random, count: usize, range: usize) -> Vec<usize> {
    let mut frames: Vec<usize> = (0..range).collect();
    while frames.len() > count {
        frames.remove(random.below(frames.len()));
    }
    frames
}

#[test]
fn equals_the_table_on_random_lists() {
    let mut random = Random::new(1);
    for _ in 0..6000 {
        let larger_count = 1 + random.below(14);
        let smaller_count = random.below(larger_count + 1);
        let range = larger_count + random.below(30);
        let smaller = ascending(&mut random, smaller_count, range);
        let larger = ascending(&mut random, larger_count, range);
        assert_eq!(
            partners(&smaller, &larger),
            partners_by_table(&smaller, &larger),
            "{smaller:?} {larger:?}"
        );
    }
}

#[test]
fn equals_the_table_on_long_lists() {
    let mut random = Random::new(2);
    for round in 0..60 {
        let larger = ascending(&mut random, 150, 200 + 40 * round);
        let smaller = ascending(&mut random, 40 + round, 200 + 40 * round);
        assert_eq!(
            partners(&smaller, &larger),
            partners_by_table(&smaller, &larger)
        );
    }
}

#[test]
fn equals_the_table_on_minima_of_a_signal_and_its_filtered_self() {
    let mut random = Random::new(3);
    let noise: Vec<f64> = (0..3000).map(|_| random.unit()).collect();
    for cutoff_hz in [20.0, 8.0, 3.0, 0.5] {
        let filtered = crate::hodrick_prescott::low_pass(&noise, cutoff_hz, 120.0);
        let (smaller, larger) = (minima(&filtered, 0.0), minima(&noise, 0.0));
        assert!(smaller.len() < larger.len());
        assert_eq!(
            partners(&smaller, &larger),
            partners_by_table(&smaller, &larger)
        );
    }
}

#[test]
fn of_equal_partners_the_earliest_is_taken() {
    assert_eq!(partners(&[5], &[3, 7]), [0]);
    assert_eq!(partners(&[5, 6], &[4, 5, 7]), [1, 2]);
    assert_eq!(partners(&[], &[1, 2]), [] as [usize; 0]);
    assert_eq!(partners(&[9], &[1]), [0]);
}
