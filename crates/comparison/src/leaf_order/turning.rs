//! Subtrees in a row in; their leaves in a row out, in each subtree the side nearer to the neighbour
//! turned outward.

use super::layout::Layout;
use crate::dendrogram::Dendrogram;

/// So many leaves stand for a cluster, spread evenly over it: turning is a matter of the eye, and
/// all pairs of large clusters would take longer than the rest of the order.
const REPRESENTATIVES: usize = 16;

/// Turns the branches within subtrees.
pub(super) struct Turning<'a, D> {
    pub(super) dendrogram: &'a Dendrogram,
    pub(super) layout: &'a Layout,
    pub(super) distance: &'a D,
}

/// A cluster and those on its two sides.
#[derive(Clone, Copy)]
struct Between {
    before: Option<usize>,
    cluster: usize,
    after: Option<usize>,
}

impl<D: Fn(usize, usize) -> f64> Turning<'_, D> {
    /// The leaves of all subtrees, which stay in their order.
    pub(super) fn leaves(&self, subtrees: &[usize]) -> Vec<usize> {
        let mut leaves = Vec::with_capacity(self.dendrogram.items);
        let mut waiting = Vec::new();
        for (index, &cluster) in subtrees.iter().enumerate() {
            waiting.push(Between {
                before: index.checked_sub(1).map(|before| subtrees[before]),
                cluster,
                after: subtrees.get(index + 1).copied(),
            });
            while let Some(between) = waiting.pop() {
                match self.dendrogram.children(between.cluster) {
                    None => leaves.push(between.cluster),
                    Some((left, right)) => {
                        let (one, other) = self.turned(between, left, right);
                        waiting.push(Between {
                            before: Some(one),
                            cluster: other,
                            after: between.after,
                        });
                        waiting.push(Between {
                            before: between.before,
                            cluster: one,
                            after: Some(other),
                        });
                    }
                }
            }
        }
        leaves
    }

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
