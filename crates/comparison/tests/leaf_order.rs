//! The order of leaves: the cheapest of all where there are few, whole and turned where there are many.

use comparison::dendrogram::Dendrogram;
use comparison::distance::euclidean;
use comparison::feature::{FEATURE_LENGTH, Vector};
use comparison::leaf_order::{self, MOST_OPTIMAL_LEAVES, OrderSteps};
use comparison::linkage;
use proptest::prelude::*;

fn vectors(most: usize) -> impl Strategy<Value = Vec<Vector>> {
    let vector = prop::array::uniform12(-1.0..1.0_f64);
    prop::collection::vec(vector, 1..most)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn no_turning_of_branches_is_cheaper(vectors in vectors(10)) {
        let tree = linkage::ward(&vectors);
        let distance = |one: usize, other: usize| euclidean(&vectors[one], &vectors[other]);
        let order = leaf_order::optimal(&tree, &distance);
        let least = all_orders(&tree, 2 * tree.items - 2)
            .iter()
            .map(|leaves| leaf_order::cost(leaves, &distance))
            .fold(f64::INFINITY, f64::min);
        assert_allowed(&tree, &order.leaves);
        prop_assert!(order.optimal);
        prop_assert!(leaf_order::cost(&order.leaves, &distance) <= least + 1e-12);
        prop_assert!(order.leaves.first() <= order.leaves.last());
    }

    #[test]
    fn equal_distances_have_an_order(vectors in prop::collection::vec(0..3_u8, 1..80)) {
        let vectors: Vec<Vector> = vectors.iter().map(|&value| [f64::from(value); 12]).collect();
        let tree = linkage::ward(&vectors);
        let distance = |one: usize, other: usize| euclidean(&vectors[one], &vectors[other]);
        assert_allowed(&tree, &leaf_order::optimal(&tree, &distance).leaves);
    }
}

#[test]
fn nothing_has_an_empty_order() {
    let order = leaf_order::optimal(&linkage::ward(&[]), &|_, _| 0.0);
    assert!(order.leaves.is_empty());
    assert!(order.optimal);
}

#[test]
fn points_on_a_line_stand_in_their_order() {
    let order = line_order(MOST_OPTIMAL_LEAVES);
    assert!(order.optimal);
    assert!(order.leaves.is_sorted());
}

#[test]
fn many_points_on_a_line_stand_in_their_order_too() {
    let order = line_order(2 * MOST_OPTIMAL_LEAVES + 500);
    assert!(!order.optimal);
    assert!(order.leaves.is_sorted());
}

/// A chain of a tree, as deep as it can be.
#[test]
fn deep_trees_are_ordered() {
    for count in [900, 3_000] {
        let place = |index: usize| (index * index) as f64;
        let tree = line_tree(count, place);
        let order = leaf_order::optimal(&tree, &|one, other| (place(one) - place(other)).abs());
        assert_allowed(&tree, &order.leaves);
    }
}

#[test]
fn an_order_in_pieces_is_the_same() {
    for count in [700, 1_400] {
        let place = |index: usize| (index * 7_919 % 10_007) as f64;
        let tree = line_tree(count, place);
        let distance = |one: usize, other: usize| (place(one) - place(other)).abs();
        let mut steps = OrderSteps::new(&tree);
        let mut done = 0.0;
        while done < 1.0 {
            let now = steps.step(10_000, &distance);
            assert!((done..=1.0).contains(&now));
            done = now;
        }
        assert_eq!(
            steps.finish(&distance),
            leaf_order::optimal(&tree, &distance)
        );
    }
}

fn line_order(count: usize) -> leaf_order::Order {
    // Steps that are all different, in no order.
    let place = |index: usize| 1_000.0 * index as f64 + (index * 7_919 % 1_009) as f64 / 10.0;
    let tree = line_tree(count, place);
    leaf_order::optimal(&tree, &|one, other| (place(one) - place(other)).abs())
}

fn line_tree(count: usize, place: impl Fn(usize) -> f64) -> Dendrogram {
    let point = |index: usize| {
        let mut vector = [0.0; FEATURE_LENGTH];
        vector[4] = place(index);
        vector
    };
    let points: Vec<Vector> = (0..count).map(point).collect();
    linkage::ward(&points)
}

fn all_orders(tree: &Dendrogram, cluster: usize) -> Vec<Vec<usize>> {
    if cluster < tree.items {
        return vec![vec![cluster]];
    }
    let merge = tree.merges[cluster - tree.items];
    let mut orders = Vec::new();
    for left in all_orders(tree, merge.left) {
        for right in all_orders(tree, merge.right) {
            orders.push([left.clone(), right.clone()].concat());
            orders.push([right, left.clone()].concat());
        }
    }
    orders
}

/// Every leaf once, and those of every cluster side by side.
fn assert_allowed(tree: &Dendrogram, leaves: &[usize]) {
    let mut places = vec![usize::MAX; tree.items];
    for (place, &leaf) in leaves.iter().enumerate() {
        assert_eq!(places[leaf], usize::MAX);
        places[leaf] = place;
    }
    assert_eq!(leaves.len(), tree.items);
    let mut spans: Vec<(usize, usize)> = places.iter().map(|&place| (place, place)).collect();
    for merge in &tree.merges {
        let (left, right) = (spans[merge.left], spans[merge.right]);
        let span = (left.0.min(right.0), left.1.max(right.1));
        assert_eq!(span.1 - span.0 + 1, merge.size);
        spans.push(span);
    }
}
