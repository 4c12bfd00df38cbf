//! A large tree in; its top out, a tree whose leaves are subtrees.

use crate::dendrogram::{Dendrogram, Merge};

/// The last merges of a tree.
pub(super) struct Top {
    /// The clusters that are its leaves, lowest number first.
    pub(super) subtrees: Vec<usize>,
    /// The merges of the subtrees; a size counts subtrees.
    pub(super) tree: Dendrogram,
}

impl Top {
    /// The top with `most` leaves; the whole tree if it has no more.
    pub(super) fn of(dendrogram: &Dendrogram, most: usize) -> Self {
        let made = dendrogram.merges_made(most);
        let made = if dendrogram.items > most { made } else { 0 };
        let subtrees = subtrees(dendrogram, made);
        let mut numbers = vec![usize::MAX; dendrogram.items + dendrogram.merges.len()];
        for (number, &subtree) in subtrees.iter().enumerate() {
            numbers[subtree] = number;
        }
        let mut sizes = vec![1; subtrees.len()];
        let mut merges = Vec::new();
        for (index, merge) in dendrogram.merges.iter().enumerate().skip(made) {
            let (left, right) = (numbers[merge.left], numbers[merge.right]);
            let size = sizes[left] + sizes[right];
            numbers[dendrogram.items + index] = sizes.len();
            sizes.push(size);
            merges.push(Merge {
                left,
                right,
                height: merge.height,
                size,
            });
        }
        let items = subtrees.len();
        Self {
            subtrees,
            tree: Dendrogram { items, merges },
        }
    }
}

/// The clusters there are after the first `made` merges.
fn subtrees(dendrogram: &Dendrogram, made: usize) -> Vec<usize> {
    let mut is_merged = vec![false; dendrogram.items + made];
    for merge in &dendrogram.merges[..made] {
        is_merged[merge.left] = true;
        is_merged[merge.right] = true;
    }
    let clusters = is_merged.iter().enumerate();
    let left = clusters.filter(|&(_, &is_merged)| !is_merged);
    left.map(|(cluster, _)| cluster).collect()
}
