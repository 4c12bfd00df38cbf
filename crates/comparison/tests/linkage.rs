//! The linkages against their definitions, in pieces as at once, and on odd input.

mod support;

use comparison::condensed::Condensed;
use comparison::dendrogram::{Dendrogram, Merge};
use comparison::feature::{FEATURE_LENGTH, Vector};
use comparison::linkage::{self, GroupAverageSteps, WardSteps};
use proptest::prelude::*;
use support::{is_close, plain};

fn vectors(most: usize) -> impl Strategy<Value = Vec<Vector>> {
    let vector = prop::array::uniform12(-1.0..1.0_f64);
    prop::collection::vec(vector, 1..most)
}

fn distances(vectors: &[Vector]) -> Condensed {
    Condensed::of_vectors(vectors)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn ward_is_its_definition(vectors in vectors(24)) {
        assert_same(&linkage::ward(&vectors).merges, &plain::ward(&vectors));
    }

    #[test]
    fn group_average_is_its_definition(vectors in vectors(24)) {
        let condensed = distances(&vectors);
        let found = linkage::group_average(&condensed);
        assert_same(&found.merges, &plain::group_average(&condensed));
    }

    #[test]
    fn pieces_make_the_same_trees(vectors in vectors(60), budget in 1..2_000_usize) {
        let mut ward = WardSteps::new(&vectors);
        while_open(|| ward.step(budget));
        prop_assert_eq!(ward.finish(), linkage::ward(&vectors));
        let condensed = distances(&vectors);
        let mut average = GroupAverageSteps::new(&condensed);
        while_open(|| average.step(budget));
        prop_assert_eq!(average.finish(), linkage::group_average(&condensed));
    }
}

#[test]
fn many_vectors_merge_in_pieces_as_at_once() {
    let vectors = spread(1_300);
    let mut steps = WardSteps::new(&vectors);
    while_open(|| steps.step(5_000));
    assert_eq!(steps.finish(), linkage::ward(&vectors));
}

#[test]
fn nothing_and_one_thing_have_no_merges() {
    assert!(linkage::ward(&[]).merges.is_empty());
    assert!(linkage::ward(&[[0.5; FEATURE_LENGTH]]).merges.is_empty());
    assert_eq!(WardSteps::new(&[]).step(1), 1.0);
    let none = Condensed::from_fn(0, |_, _| 0.0);
    assert!(linkage::group_average(&none).merges.is_empty());
}

#[test]
fn numbers_that_are_none_still_make_a_tree() {
    for count in [40, 1_100] {
        let mut vectors = spread(count);
        vectors[3][2] = f64::NAN;
        vectors[5] = [f64::INFINITY; FEATURE_LENGTH];
        vectors[6] = [f64::INFINITY; FEATURE_LENGTH];
        vectors[9][0] = f64::NEG_INFINITY;
        assert_whole(&linkage::ward(&vectors));
        assert_whole(&linkage::group_average(&distances(&vectors)));
    }
}

#[test]
fn copies_of_many_vectors_merge_at_no_height() {
    let one: Vector = std::array::from_fn(|k| 0.1 + 0.7 * k as f64);
    let tree = linkage::ward(&vec![one; 1_500]);
    assert_whole(&tree);
    assert!(tree.merges.iter().all(|merge| merge.height == 0.0));
}

fn while_open(mut step: impl FnMut() -> f64) {
    let mut done = 0.0;
    while done < 1.0 {
        let now = step();
        assert!((done..=1.0).contains(&now), "{done} then {now}");
        done = now;
    }
}

/// Vectors without system and without ties.
fn spread(count: usize) -> Vec<Vector> {
    let mut state = 1_u32;
    let mut next = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(state >> 8)
    };
    let vector = |_| {
        let mut vector = [0.0; FEATURE_LENGTH];
        vector.fill_with(&mut next);
        vector
    };
    (0..count).map(vector).collect()
}

fn assert_whole(tree: &Dendrogram) {
    assert_eq!(tree.merges.len() + 1, tree.items);
    assert_eq!(tree.merges.last().map(|merge| merge.size), Some(tree.items));
}

fn assert_same(found: &[Merge], expected: &[Merge]) {
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(expected) {
        assert_eq!(
            (found.left, found.right, found.size),
            (expected.left, expected.right, expected.size)
        );
        assert!(is_close(found.height, expected.height, 1e-9));
    }
}
