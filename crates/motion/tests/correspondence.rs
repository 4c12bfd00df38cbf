//! The correspondence of minima against the plain table, on random and on real minima, ties
//! included.

mod support;

use motion::hodrick_prescott::low_pass;
use motion::keypose::Options;
use motion::keypose::candidates::minima;
use motion::keypose::correspondence::partners;
use support::{golden_clips, numbers};
use test_support::Random;

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
        let filtered = low_pass(&noise, cutoff_hz, 120.0);
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

/// The table over the offsets `larger index − smaller index`, the other way round: of equal costs
/// the smaller offset, row by row.
fn partners_by_offsets(smaller: &[usize], larger: &[usize]) -> Vec<usize> {
    let offsets = larger.len() - smaller.len() + 1;
    let mut costs = vec![0usize; offsets];
    let mut choices = Vec::new();
    for (row, &frame) in smaller.iter().enumerate() {
        let mut choice = vec![0; offsets];
        let mut best = 0;
        for offset in 0..offsets {
            if costs[offset] < costs[best] {
                best = offset;
            }
            choice[offset] = best;
        }
        costs = (0..offsets)
            .map(|offset| costs[choice[offset]] + frame.abs_diff(larger[row + offset]))
            .collect();
        choices.push(choice);
    }
    let mut offset = (0..offsets)
        .min_by_key(|&offset| costs[offset])
        .unwrap_or(0);
    let mut partners = vec![0; smaller.len()];
    for row in (0..smaller.len()).rev() {
        partners[row] = row + offset;
        offset = choices[row][offset];
    }
    partners
}

#[test]
fn the_two_tables_agree() {
    let mut random = Random::new(7);
    for _ in 0..1000 {
        let larger_count = 1 + random.below(14);
        let smaller_count = random.below(larger_count + 1);
        let smaller = ascending(&mut random, smaller_count, 25);
        let larger = ascending(&mut random, larger_count, 25);
        assert_eq!(
            partners_by_offsets(&smaller, &larger),
            partners_by_table(&smaller, &larger)
        );
    }
}

#[test]
fn equals_both_tables_on_all_levels_of_real_speeds() {
    for (name, clip) in golden_clips() {
        let speed = numbers(&clip["speed"]);
        let rate_hz = clip["frame_rate_hz"].as_f64().expect("a rate");
        let floor = 1e-6 * speed.iter().copied().fold(0.0, f64::max);
        let mut survivors = minima(&speed, floor);
        for scale_hz in Options::default().scales_hz() {
            let level = minima(&low_pass(&speed, scale_hz, rate_hz), floor);
            let is_smaller = level.len() <= survivors.len();
            let (smaller, larger) = if is_smaller {
                (&level, &survivors)
            } else {
                (&survivors, &level)
            };
            let found = partners(smaller, larger);
            assert_eq!(
                found,
                partners_by_table(smaller, larger),
                "{name} {scale_hz} Hz"
            );
            assert_eq!(
                found,
                partners_by_offsets(smaller, larger),
                "{name} {scale_hz} Hz"
            );
            survivors = match is_smaller {
                true => level,
                false => found.iter().map(|&partner| level[partner]).collect(),
            };
        }
    }
}
