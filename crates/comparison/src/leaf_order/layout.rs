//! A tree in; its leaves in the order of the tree out, so that every cluster is a range of places.

use crate::dendrogram::Dendrogram;
use std::ops::Range;

/// Where the leaves of every cluster stand when the tree is drawn as it is.
pub(super) struct Layout {
    /// The item at every place.
    pub(super) items: Vec<usize>,
    /// The places of every cluster, items first, then merges.
    pub(super) places: Vec<Range<usize>>,
}

impl Layout {
    /// Left children first.
    pub(super) fn of(dendrogram: &Dendrogram) -> Self {
        let count = dendrogram.items;
        let mut starts = vec![0; count + dendrogram.merges.len()];
        let size = |cluster: usize| {
            let merge = cluster.checked_sub(count);
            merge.map_or(1, |index| dendrogram.merges[index].size)
        };
        for (index, merge) in dendrogram.merges.iter().enumerate().rev() {
            starts[merge.left] = starts[count + index];
            starts[merge.right] = starts[count + index] + size(merge.left);
        }
        let mut items = vec![0; count];
        for item in 0..count {
            items[starts[item]] = item;
        }
        let ranges = starts.iter().enumerate();
        let places = ranges.map(|(cluster, &start)| start..start + size(cluster));
        Self {
            items,
            places: places.collect(),
        }
    }
}
