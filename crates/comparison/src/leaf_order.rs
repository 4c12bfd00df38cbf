//! A tree and the distances of its leaves in; the order of the leaves out that the matrix is shown in.

mod exact;
mod layout;

use crate::dendrogram::Dendrogram;

/// Up to so many leaves the order is the best there is.
pub const MOST_OPTIMAL_LEAVES: usize = 1_000;

/// The leaves of a tree in a row.
#[derive(Clone, Debug, PartialEq)]
pub struct Order {
    /// The items, each once.
    pub leaves: Vec<usize>,
    /// Whether no order that the tree allows has a lower cost.
    pub optimal: bool,
}

/// The order, among those that turn the branches of the tree, with the least sum of distances between
/// neighbours (Bar-Joseph, Gifford and Jaakkola 2001). Read in the direction in which the lower of the
/// two end items comes first.
pub fn optimal(dendrogram: &Dendrogram, distance: &impl Fn(usize, usize) -> f64) -> Order {
    let mut leaves = exact::order(dendrogram, distance);
    if leaves.first() > leaves.last() {
        leaves.reverse();
    }
    Order {
        leaves,
        optimal: true,
    }
}

/// The sum of the distances between neighbours.
pub fn cost(leaves: &[usize], distance: &impl Fn(usize, usize) -> f64) -> f64 {
    let pairs = leaves.windows(2);
    pairs.map(|pair| distance(pair[0], pair[1])).sum()
}
