//! Pairs of items whose clusters merge, in; the numbers of those clusters out.

use super::Merge;

/// Which cluster every item lies in, while clusters merge.
pub(super) struct Unions {
    parents: Vec<usize>,
    sizes: Vec<usize>,
}

impl Unions {
    /// Every item alone.
    pub(super) fn of(items: usize) -> Self {
        Self {
            parents: (0..items).collect(),
            sizes: vec![1; items],
        }
    }

    /// Merges the clusters of two items into the next number.
    pub(super) fn merge(&mut self, one: usize, other: usize, height: f64) -> Merge {
        let (one, other) = (self.find(one), self.find(other));
        let (left, right) = (one.min(other), one.max(other));
        let cluster = self.parents.len();
        let size = self.sizes[left] + self.sizes[right];
        self.parents[left] = cluster;
        self.parents[right] = cluster;
        self.parents.push(cluster);
        self.sizes.push(size);
        Merge {
            left,
            right,
            height,
            size,
        }
    }

    /// The cluster of an item; the way there is halved for the next time.
    fn find(&mut self, item: usize) -> usize {
        let mut at = item;
        while self.parents[at] != at {
            self.parents[at] = self.parents[self.parents[at]];
            at = self.parents[at];
        }
        at
    }
}
