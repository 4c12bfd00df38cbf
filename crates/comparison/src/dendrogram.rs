//! Merges of clusters in, as a linkage finds them; a tree in SciPy's labelling out, with its cuts.

mod newick;
mod unions;

use unions::Unions;

/// Two clusters that become one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Merge {
    /// The cluster with the lower number: an item below `items`, else `items` + the index of its merge.
    pub left: usize,
    /// The cluster with the higher number.
    pub right: usize,
    /// The distance of the two.
    pub height: f64,
    /// Items in the new cluster.
    pub size: usize,
}

/// A tree of merges, lowest first, labelled as SciPy's linkage matrix.
#[derive(Clone, Debug, PartialEq)]
pub struct Dendrogram {
    /// Leaves of the tree.
    pub items: usize,
    /// The `items − 1` merges.
    pub merges: Vec<Merge>,
}

/// A merge as a linkage finds it: one item of each of the two clusters, and their distance.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Joined {
    pub(crate) one: usize,
    pub(crate) other: usize,
    pub(crate) height: f64,
}

impl Dendrogram {
    /// The tree of `items − 1` merges in any order: sorted by height (equal ones keep their order),
    /// then numbered.
    pub(crate) fn of_joined(items: usize, mut joined: Vec<Joined>) -> Self {
        joined.sort_by(|a, b| a.height.total_cmp(&b.height));
        let mut unions = Unions::of(items);
        let merges = joined
            .iter()
            .map(|join| unions.merge(join.one, join.other, join.height))
            .collect();
        Self { items, merges }
    }

    /// The cluster of every item when the tree is cut into `clusters` (held within 1 and `items`),
    /// numbered from 0 by their first items.
    #[must_use]
    pub fn cut(&self, clusters: usize) -> Vec<usize> {
        self.cut_in_order(clusters, 0..self.items)
    }

    /// As [`Self::cut`], numbered in the order of `leaves`.
    #[must_use]
    pub fn cut_by_leaves(&self, clusters: usize, leaves: &[usize]) -> Vec<usize> {
        self.cut_in_order(clusters, leaves.iter().copied())
    }

    /// A height that cuts the tree into `clusters`: the middle between the last merge below and the
    /// first above. For one cluster the height of the tree; for as many as items half the first merge.
    #[must_use]
    pub fn cut_height(&self, clusters: usize) -> f64 {
        let made = self.merges_made(clusters);
        let below = made.checked_sub(1).map_or(0.0, |last| self.height_of(last));
        let above = self.merges.get(made).map_or(below, |merge| merge.height);
        below + (above - below) / 2.0
    }

    /// How many clusters a cut at `height` leaves: merges up to that height are made.
    #[must_use]
    pub fn clusters_at(&self, height: f64) -> usize {
        let made = self.merges.partition_point(|merge| merge.height <= height);
        self.items - made
    }

    /// The children of a cluster that is no item.
    pub(crate) fn children(&self, cluster: usize) -> Option<(usize, usize)> {
        let merge = self.merges.get(cluster.checked_sub(self.items)?)?;
        Some((merge.left, merge.right))
    }

    /// The number of the cluster of all; none without items.
    pub(crate) fn root(&self) -> Option<usize> {
        (self.items + self.merges.len()).checked_sub(1)
    }

    /// How many merges leave that many clusters.
    pub(crate) fn merges_made(&self, clusters: usize) -> usize {
        self.merges
            .len()
            .min(self.items.saturating_sub(clusters.max(1)))
    }

    fn height_of(&self, merge: usize) -> f64 {
        self.merges[merge].height
    }

    fn cut_in_order(&self, clusters: usize, order: impl Iterator<Item = usize>) -> Vec<usize> {
        let tops = self.tops(self.merges_made(clusters));
        let mut number_of_top = vec![usize::MAX; self.items + self.merges.len()];
        let mut next = 0;
        for item in order {
            let number = &mut number_of_top[tops[item]];
            if *number == usize::MAX {
                *number = next;
                next += 1;
            }
        }
        tops[..self.items]
            .iter()
            .map(|&top| number_of_top[top])
            .collect()
    }

    /// The cluster every item and cluster lies in after the first `made` merges.
    fn tops(&self, made: usize) -> Vec<usize> {
        let mut tops: Vec<usize> = (0..self.items + made).collect();
        for index in (0..made).rev() {
            let merge = self.merges[index];
            tops[merge.left] = tops[self.items + index];
            tops[merge.right] = tops[self.items + index];
        }
        tops
    }
}
