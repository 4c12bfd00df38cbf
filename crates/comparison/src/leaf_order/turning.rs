//! Subtrees in a row in; their leaves in a row out, in each subtree the side nearer to the neighbour
//! turned outward.

use super::layout::Layout;
use crate::dendrogram::Dendrogram;

/// So many leaves stand for a cluster, spread evenly over it: turning is a matter of the eye, and
/// all pairs of large clusters would take longer than the rest of the order.
const REPRESENTATIVES: usize = 16;

/// The clusters still to be turned and the leaves that are in their place.
pub(super) struct Turning {
    /// The next one last.
    waiting: Vec<Between>,
    leaves: Vec<usize>,
}

/// A cluster and those on its two sides.
#[derive(Clone, Copy)]
struct Between {
    before: Option<usize>,
    cluster: usize,
    after: Option<usize>,
}

impl Turning {
    /// Subtrees, which stay in their order.
    pub(super) fn new(subtrees: &[usize]) -> Self {
        let between = |(index, &cluster): (usize, &usize)| Between {
            before: index.checked_sub(1).map(|before| subtrees[before]),
            cluster,
            after: subtrees.get(index + 1).copied(),
        };
        Self {
            waiting: subtrees.iter().enumerate().map(between).rev().collect(),
            leaves: Vec::new(),
        }
    }

    pub(super) fn is_open(&self) -> bool {
        !self.waiting.is_empty()
    }

    /// The leaves.
    pub(super) fn finish(self) -> Vec<usize> {
        self.leaves
    }

    /// The next leaf, or the next branch; how many distances it took, about.
    pub(super) fn advance<D>(&mut self, way: &Ways<D>) -> usize
    where
        D: Fn(usize, usize) -> f64,
    {
        let Some(between) = self.waiting.pop() else {
            return 0;
        };
        let Some((left, right)) = way.dendrogram.children(between.cluster) else {
            self.leaves.push(between.cluster);
            return 1;
        };
        let (one, other) = way.turned(between, left, right);
        self.waiting.push(Between {
            before: Some(one),
            cluster: other,
            after: between.after,
        });
        self.waiting.push(Between {
            before: between.before,
            cluster: one,
            after: Some(other),
        });
        4 * REPRESENTATIVES * REPRESENTATIVES
    }
}

/// What tells how far clusters are from each other.
pub(super) struct Ways<'a, D> {
    pub(super) dendrogram: &'a Dendrogram,
    pub(super) layout: &'a Layout,
    pub(super) distance: &'a D,
}

impl<D: Fn(usize, usize) -> f64> Ways<'_, D> {
    /// The children in the order in which they are nearer to what they come to stand beside.
    fn turned(&self, between: Between, left: usize, right: usize) -> (usize, usize) {
        let outward = |first: usize, last: usize| {
            let before = between
                .before
                .map_or(0.0, |before| self.mean(before, first));
            before + between.after.map_or(0.0, |after| self.mean(last, after))
        };
        if outward(right, left) < outward(left, right) {
            (right, left)
        } else {
            (left, right)
        }
    }

    /// The mean distance of the representatives of two clusters.
    fn mean(&self, one: usize, other: usize) -> f64 {
        let mut sum = 0.0;
        let mut pairs = 0.0;
        for a in self.representatives(one) {
            for b in self.representatives(other) {
                sum += (self.distance)(a, b);
                pairs += 1.0;
            }
        }
        sum / pairs
    }

    fn representatives(&self, cluster: usize) -> impl Iterator<Item = usize> + '_ {
        let leaves = &self.layout.items[self.layout.places[cluster].clone()];
        let count = leaves.len().min(REPRESENTATIVES);
        (0..count).map(move |index| leaves[index * leaves.len() / count])
    }
}
