//! Ward's clustering of numbers: sorted values in, the sequence of merges out.
//!
//! Squared Euclidean distance, Lance–Williams, heights squared:
//! `2 n_a n_b / (n_a + n_b) · (mean_a − mean_b)²`. On a line Ward only ever merges neighbours, so
//! that a merge takes away the boundary between two of them, and O(n log n) suffices.
//!
//! Source: J. H. Ward, "Hierarchical Grouping to Optimize an Objective Function", 1963.

use std::cmp::{Ordering, Reverse};
use std::collections::BinaryHeap;

/// One merge of two neighbouring clusters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Merge {
    /// The boundary that it takes away: the index of the first value right of it.
    pub boundary: usize,
    /// The merge height, squared.
    pub height: f64,
}

/// The n−1 merges of `values`, ascending numbers, in order. Of equal heights the leftmost
/// boundary goes first.
pub fn merges(values: &[f64]) -> Vec<Merge> {
    let mut line = Line::new(values);
    let mut merges = Vec::with_capacity(values.len().saturating_sub(1));
    while let Some(Reverse(next)) = line.queue.pop() {
        if line.is_current(&next) {
            merges.push(Merge {
                boundary: next.boundary,
                height: next.height,
            });
            line.merge(next.boundary);
        }
    }
    merges
}

/// A merge that could come next; `left` and `right` are the sizes at the time it was considered.
#[derive(Clone, Copy, Debug)]
struct Proposal {
    height: f64,
    boundary: usize,
    left: usize,
    right: usize,
}

impl Ord for Proposal {
    fn cmp(&self, other: &Self) -> Ordering {
        let by_height = self.height.total_cmp(&other.height);
        by_height.then(self.boundary.cmp(&other.boundary))
    }
}

impl PartialOrd for Proposal {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Proposal {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Proposal {}

/// Clusters side by side. Entry i of `sizes` and `sums` is the cluster that starts at value i;
/// `size_before` holds at a start the size of the cluster that ends there.
struct Line {
    sizes: Vec<usize>,
    sums: Vec<f64>,
    size_before: Vec<usize>,
    queue: BinaryHeap<Reverse<Proposal>>,
}

impl Line {
    fn new(values: &[f64]) -> Self {
        let mut line = Self {
            sizes: vec![1; values.len()],
            sums: values.to_vec(),
            size_before: vec![1; values.len()],
            queue: BinaryHeap::new(),
        };
        for boundary in 1..values.len() {
            line.propose(boundary);
        }
        line
    }

    fn propose(&mut self, boundary: usize) {
        let (left, right) = (self.size_before[boundary], self.sizes[boundary]);
        let (n_a, n_b) = (left as f64, right as f64);
        let gap = self.sums[boundary] / n_b - self.sums[boundary - left] / n_a;
        let height = 2.0 * n_a * n_b / (n_a + n_b) * (gap * gap);
        self.queue.push(Reverse(Proposal {
            height,
            boundary,
            left,
            right,
        }));
    }

    /// Neither cluster has grown since, nor has the boundary gone (its sizes are then zero).
    fn is_current(&self, proposal: &Proposal) -> bool {
        proposal.left == self.size_before[proposal.boundary]
            && proposal.right == self.sizes[proposal.boundary]
    }

    fn merge(&mut self, boundary: usize) {
        let start = boundary - self.size_before[boundary];
        let end = boundary + self.sizes[boundary];
        self.sums[start] += self.sums[boundary];
        self.sizes[start] = end - start;
        self.sizes[boundary] = 0;
        self.size_before[boundary] = 0;
        if end < self.sizes.len() {
            self.size_before[end] = end - start;
            self.propose(end);
        }
        if start > 0 {
            self.propose(start);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use test_support::Random;

    /// Lance–Williams on the full table of squared distances, no thought given to the order.
    fn merges_by_table(values: &[f64]) -> Vec<Merge> {
        let count = values.len();
        let mut starts: Vec<usize> = (0..count).collect();
        let mut sizes = vec![1.0; count];
        let mut distance: Vec<Vec<f64>> = values
            .iter()
            .map(|a| values.iter().map(|b| (a - b) * (a - b)).collect())
            .collect();
        let mut merges = Vec::new();
        while starts.len() > 1 {
            let (mut a, mut b) = (0, 1);
            for i in 0..starts.len() {
                for j in i + 1..starts.len() {
                    if distance[starts[i]][starts[j]] < distance[starts[a]][starts[b]] {
                        (a, b) = (i, j);
                    }
                }
            }
            let (first, second) = (starts[a], starts[b]);
            let height = distance[first][second];
            merges.push(Merge {
                boundary: second,
                height,
            });
            for &other in &starts {
                if other != first && other != second {
                    let (n_a, n_b, n_c): (f64, f64, f64) =
                        (sizes[first], sizes[second], sizes[other]);
                    let sum = (n_a + n_c) * distance[first][other]
                        + (n_b + n_c) * distance[second][other]
                        - n_c * height;
                    distance[first][other] = sum / (n_a + n_b + n_c);
                    distance[other][first] = distance[first][other];
                }
            }
            sizes[first] += sizes[second];
            starts.remove(b);
        }
        merges
    }

    #[test]
    fn equals_the_plain_table_on_random_numbers() {
        let mut random = Random::new(4);
        for count in 1..80 {
            let mut values: Vec<f64> = (0..count).map(|_| 20.0 * random.unit()).collect();
            values.sort_by(f64::total_cmp);
            let (fast, plain) = (merges(&values), merges_by_table(&values));
            assert_eq!(fast.len(), plain.len());
            for (fast, plain) in fast.iter().zip(&plain) {
                assert_eq!(fast.boundary, plain.boundary);
                // Heights are differences of squares of at most 20² in the table.
                assert!((fast.height - plain.height).abs() <= 1e-11 * (1.0 + plain.height));
            }
        }
    }

    #[test]
    fn heights_rise_and_boundaries_all_go() {
        let mut random = Random::new(5);
        let mut values: Vec<f64> = (0..500).map(|_| random.below(40) as f64).collect();
        values.sort_by(f64::total_cmp);
        let merges = merges(&values);
        assert!(
            merges
                .windows(2)
                .all(|pair| pair[0].height <= pair[1].height * (1.0 + 1e-12))
        );
        let mut boundaries: Vec<usize> = merges.iter().map(|merge| merge.boundary).collect();
        boundaries.sort_unstable();
        assert_eq!(boundaries, (1..500).collect::<Vec<_>>());
    }
}
