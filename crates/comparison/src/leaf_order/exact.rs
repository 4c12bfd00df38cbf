//! A tree and distances of its leaves in; the order of least cost out, by dynamic programming over
//! the two end leaves of every cluster.
//!
//! Leaves stand at the places of the tree drawn as it is, so clusters are ranges, and the cheapest
//! way through two of them is two products of matrices in which + stands for · and min for +.

use super::layout::Layout;
use super::least_sums::{Part, least_sums};
use super::square::Square;
use crate::dendrogram::Dendrogram;
use std::ops::Range;

/// The cheapest ways through the clusters of a tree.
pub(super) struct Table {
    tree: Dendrogram,
    layout: Layout,
    /// Distances between the leaves at two places.
    pub(super) distances: Square,
    /// The least cost of the smallest cluster that holds both places, with them at its two ends.
    costs: Square,
}

impl Table {
    /// Without distances.
    pub(super) fn of(tree: Dendrogram) -> Self {
        let side = tree.items;
        Self {
            layout: Layout::of(&tree),
            tree,
            distances: Square::of(side),
            costs: Square::of(side),
        }
    }

    pub(super) fn leaves(&self) -> usize {
        self.tree.items
    }

    pub(super) fn merges(&self) -> usize {
        self.tree.merges.len()
    }

    /// The leaf at a place.
    pub(super) fn leaf(&self, place: usize) -> usize {
        self.layout.items[place]
    }

    /// Sums looked at to fill in a row of a merge, about.
    pub(super) fn sums_of_a_row(&self, merge: usize) -> usize {
        let merge = self.tree.merges[merge];
        let (left, right) = (self.size(merge.left), self.size(merge.right));
        right * (left + right) / 2
    }

    /// The rows of a merge: the places of its left cluster.
    pub(super) fn rows(&self, merge: usize) -> Range<usize> {
        self.layout.places[self.tree.merges[merge].left].clone()
    }

    fn size(&self, cluster: usize) -> usize {
        self.layout.places[cluster].len()
    }

    /// The costs of some rows of a merge; all those of the merges below come first.
    pub(super) fn fill(&mut self, merge: usize, rows: &Range<usize>) {
        let merge = self.tree.merges[merge];
        let columns = self.layout.places[merge.right].clone();
        for (outer, inner) in self.ends(merge.left) {
            let outer = outer.start.max(rows.start)..outer.end.min(rows.end);
            if !outer.is_empty() {
                self.fill_rows(&outer, &inner, merge.right, &columns);
            }
        }
    }

    /// The costs between one end at `outer`, whose cluster goes on to `inner`, and the other in the
    /// cluster `right`, which lies at `columns`.
    fn fill_rows(
        &mut self,
        outer: &Range<usize>,
        inner: &Range<usize>,
        right: usize,
        columns: &Range<usize>,
    ) {
        let width = columns.len();
        let mut to_near = vec![0.0; outer.len() * width];
        let mut to_far = to_near.clone();
        let within = self.costs.part(outer, inner);
        let between = self.distances.part(inner, columns);
        least_sums(within, between, &mut to_near, width);
        for (near, far) in self.ends(right) {
            let across = Part {
                values: &to_near[near.start - columns.start..],
                stride: width,
                rows: outer.len(),
                columns: near.len(),
            };
            let into = &mut to_far[far.start - columns.start..];
            least_sums(across, self.costs.part(&near, &far), into, width);
        }
        for (row, costs) in outer.clone().zip(to_far.chunks_exact(width)) {
            for (column, &cost) in columns.clone().zip(costs) {
                self.costs.set_pair(row, column, cost);
            }
        }
    }

    /// Where the two ends of a cluster can be: one in each of its children; for a leaf both are it.
    fn ends(&self, cluster: usize) -> Vec<(Range<usize>, Range<usize>)> {
        let places = &self.layout.places;
        match self.tree.children(cluster) {
            None => vec![(places[cluster].clone(), places[cluster].clone())],
            Some((left, right)) => {
                let (left, right) = (places[left].clone(), places[right].clone());
                vec![(left.clone(), right.clone()), (right, left)]
            }
        }
    }

    /// The leaves in the order of least cost; the first found of equal ones.
    pub(super) fn order(&self) -> Vec<usize> {
        let mut order = Vec::with_capacity(self.leaves());
        let mut waiting = Vec::from_iter(self.tree.root().map(|root| self.best_way(root)));
        while let Some(way) = waiting.pop() {
            match self.tree.children(way.cluster) {
                None => order.push(self.leaf(way.first)),
                Some(children) => {
                    let [before, after] = self.split(&way, children);
                    waiting.extend([after, before]);
                }
            }
        }
        order
    }

    fn best_way(&self, root: usize) -> Way {
        let (first, last) = self.tree.children(root).map_or((0, 0), |(left, right)| {
            let places = &self.layout.places;
            least(&places[left], &places[right], |first, last| {
                self.costs.at(first, last)
            })
        });
        Way {
            cluster: root,
            first,
            last,
        }
    }

    /// The ways through the two children of which a way consists.
    fn split(&self, way: &Way, (left, right): (usize, usize)) -> [Way; 2] {
        let starts_left = self.layout.places[left].contains(&way.first);
        let (one, other) = if starts_left {
            (left, right)
        } else {
            (right, left)
        };
        let ends = self.opposite(one, way.first);
        let starts = self.opposite(other, way.last);
        let (end, start) = least(&ends, &starts, |end, start| {
            let step = self.costs.at(way.first, end) + self.distances.at(end, start);
            step + self.costs.at(start, way.last)
        });
        let way_of = |cluster, first, last| Way {
            cluster,
            first,
            last,
        };
        [way_of(one, way.first, end), way_of(other, start, way.last)]
    }

    /// Where the other end of a cluster can be.
    fn opposite(&self, cluster: usize, end: usize) -> Range<usize> {
        let mut ends = self.ends(cluster).into_iter();
        let found = ends.find(|(one, _)| one.contains(&end));
        found.map_or(end..end + 1, |(_, other)| other)
    }
}

/// A way through a cluster from one place to another.
struct Way {
    cluster: usize,
    first: usize,
    last: usize,
}

/// The pair of least cost; the first of equal ones.
fn least(
    rows: &Range<usize>,
    columns: &Range<usize>,
    cost: impl Fn(usize, usize) -> f64,
) -> (usize, usize) {
    let mut best = (rows.start, columns.start);
    let mut least = f64::INFINITY;
    for row in rows.clone() {
        for column in columns.clone() {
            let value = cost(row, column);
            if value < least {
                (best, least) = ((row, column), value);
            }
        }
    }
    best
}
