//! Clusters that can tell their nearest neighbours in; the merges of their tree out.

use crate::dendrogram::{Dendrogram, Joined};

/// A cluster and how far it is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Near {
    pub(super) slot: usize,
    pub(super) distance: f64,
}

/// Clusters in slots, one for each item at first; a merged cluster takes the higher slot of its two.
pub(super) trait Clusters {
    /// The number of slots.
    fn slots(&self) -> usize;

    /// Whether the slot still holds a cluster.
    fn holds(&self, slot: usize) -> bool;

    /// The nearest other cluster: of equal ones `previous`, else the lowest slot.
    fn nearest(&mut self, slot: usize, previous: Option<usize>) -> Near;

    /// Merges the cluster in slot `gone` into the one in slot `kept`. [`Self::settle`] follows.
    fn join(&mut self, gone: usize, kept: usize, distance: f64);

    /// Does about `budget` distances of the work that a merge has left behind; whether nothing is left.
    fn settle(&mut self, _budget: usize) -> bool {
        true
    }
}

/// The walk along nearest neighbours until two are each other's, again and again.
pub(super) struct Chain<C> {
    clusters: C,
    /// Slots, each the nearest neighbour of the one before.
    slots: Vec<usize>,
    /// No slot below holds a cluster.
    first: usize,
    joined: Vec<Joined>,
}

impl<C: Clusters> Chain<C> {
    pub(super) fn of(clusters: C) -> Self {
        Self {
            clusters,
            slots: Vec::new(),
            first: 0,
            joined: Vec::new(),
        }
    }

    /// Goes on for about `budget` distances; how much is done, 0 to 1.
    pub(super) fn step(&mut self, budget: usize) -> f64 {
        let mut spent = 0;
        while spent < budget && self.left() > 1 {
            if self.clusters.settle(budget - spent) {
                spent = spent.saturating_add(self.left());
                self.advance();
            } else {
                spent = budget;
            }
        }
        self.done()
    }

    pub(super) fn finish(self) -> Dendrogram {
        self.finish_with_clusters().0
    }

    /// The tree, and what the clusters were known by.
    pub(super) fn finish_with_clusters(mut self) -> (Dendrogram, C) {
        while self.step(usize::MAX) < 1.0 {}
        let tree = Dendrogram::of_joined(self.clusters.slots(), self.joined);
        (tree, self.clusters)
    }

    /// Clusters not yet merged into another.
    fn left(&self) -> usize {
        self.clusters.slots() - self.joined.len()
    }

    /// The work of a merge shrinks with the clusters left, so what is left shrinks with their square.
    fn done(&self) -> f64 {
        if self.left() <= 1 {
            return 1.0;
        }
        let left = self.left() as f64 / self.clusters.slots() as f64;
        1.0 - left * left
    }

    /// One link more, or a merge of the last two.
    fn advance(&mut self) {
        let (top, previous) = self.ends();
        let near = self.clusters.nearest(top, previous);
        if previous == Some(near.slot) {
            self.merge(top, near);
        } else {
            self.slots.push(near.slot);
        }
    }

    /// The last of the chain and the one before; a new chain starts at the first cluster. Rounding
    /// can make a chain meet itself: what stands before a cluster that is gone is forgotten.
    fn ends(&mut self) -> (usize, Option<usize>) {
        let clusters = &self.clusters;
        let sound_from = self.slots.iter().rposition(|&slot| !clusters.holds(slot));
        self.slots.drain(..sound_from.map_or(0, |gone| gone + 1));
        if self.slots.is_empty() {
            while !self.clusters.holds(self.first) {
                self.first += 1;
            }
            self.slots.push(self.first);
        }
        let last = self.slots.len() - 1;
        (
            self.slots[last],
            last.checked_sub(1).map(|at| self.slots[at]),
        )
    }

    fn merge(&mut self, top: usize, near: Near) {
        self.slots.truncate(self.slots.len() - 2);
        let (gone, kept) = (top.min(near.slot), top.max(near.slot));
        self.clusters.join(gone, kept, near.distance);
        self.joined.push(Joined {
            one: gone,
            other: kept,
            height: near.distance,
        });
    }
}
