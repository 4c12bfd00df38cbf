//! Matrix, trees, order and cuts of real clips against SciPy's and an independent implementation's.

mod support;

use comparison::condensed::Condensed;
use comparison::cut::{bic, mojena};
use comparison::dendrogram::Merge;
use comparison::{leaf_order, linkage};
use support::{golden, indices, is_close, merges, numbers, vectors};

const TOLERANCE: f64 = 1e-9;

#[test]
fn condensed_matrix_is_that_of_scipy() {
    let Some(golden) = golden() else { return };
    let vectors = vectors(&golden["features"]);
    let condensed = Condensed::of_vectors(&vectors);
    let expected = numbers(&golden["condensed"]);
    assert_eq!(condensed.values.len(), expected.len());
    for (found, expected) in condensed.values.iter().zip(&expected) {
        assert!(is_close(*found, *expected, TOLERANCE), "{found} {expected}");
    }
}

#[test]
fn ward_is_that_of_scipy() {
    let Some(golden) = golden() else { return };
    let found = linkage::ward(&vectors(&golden["features"]));
    assert_same(&found.merges, &merges(&golden["ward"]));
}

#[test]
fn group_average_is_that_of_scipy() {
    let Some(golden) = golden() else { return };
    let found = linkage::group_average(&condensed(&golden));
    assert_same(&found.merges, &merges(&golden["average"]));
}

#[test]
fn leaf_order_costs_no_more_than_that_of_scipy() {
    let Some(golden) = golden() else { return };
    let condensed = condensed(&golden);
    let distance = |one: usize, other: usize| condensed.at(one, other);
    let tree = linkage::ward(&vectors(&golden["features"]));
    let order = leaf_order::optimal(&tree, &distance);
    assert!(order.optimal);
    let expected = golden["ward_optimal_cost"].as_f64().expect("a number");
    let cost = leaf_order::cost(&order.leaves, &distance);
    assert!(cost <= expected + 1e-12, "{cost} {expected}");
}

#[test]
fn bic_and_its_cut_are_those_of_the_reference() {
    let Some(golden) = golden() else { return };
    let vectors = vectors(&golden["features"]);
    let tree = linkage::ward(&vectors);
    let values = bic::bic(&vectors, &tree);
    let expected = numbers(&golden["bic"]["values"]);
    assert_eq!(values.len(), expected.len());
    for (found, expected) in values.iter().zip(&expected) {
        assert!(is_close(*found, *expected, TOLERANCE), "{found} {expected}");
    }
    let clusters = bic::best(&values);
    assert_eq!(clusters as u64, golden["bic"]["clusters"]);
    assert_same_partition(&tree.cut(clusters), &indices(&golden["bic"]["assignment"]));
}

#[test]
fn mojena_and_its_cut_are_those_of_the_reference() {
    let Some(golden) = golden() else { return };
    let tree = linkage::group_average(&condensed(&golden));
    let heights: Vec<f64> = tree.merges.iter().map(|merge| merge.height).collect();
    let clusters = mojena::mojena(&heights, mojena::DEVIATIONS);
    let expected = &golden["mojena_average"];
    assert_eq!(clusters as u64, expected["clusters"]);
    assert_same_partition(&tree.cut(clusters), &indices(&expected["assignment"]));
}

fn condensed(golden: &serde_json::Value) -> Condensed {
    Condensed {
        items: golden["clips"].as_array().expect("a list").len(),
        values: numbers(&golden["condensed"]),
    }
}

fn assert_same(found: &[Merge], expected: &[Merge]) {
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(expected) {
        assert_eq!(
            (found.left, found.right, found.size),
            (expected.left, expected.right, expected.size)
        );
        assert!(is_close(found.height, expected.height, TOLERANCE));
    }
}

fn assert_same_partition(found: &[usize], expected: &[usize]) {
    assert_eq!(found.len(), expected.len());
    for (one, other) in (0..found.len()).flat_map(|one| (0..one).map(move |other| (one, other))) {
        let together = expected[one] == expected[other];
        assert_eq!(found[one] == found[other], together, "{one} {other}");
    }
}
