//! A tree and distances in; the order of least cost out, by dynamic programming over the two end
//! leaves of every cluster.
//!
//! Leaves stand at the places of the tree drawn as it is, so clusters are ranges, and the cheapest
//! way through two of them is two products of matrices in which + stands for · and min for +.

use super::layout::Layout;
use crate::dendrogram::Dendrogram;
use std::ops::Range;

/// The order of least cost; the first found of equal ones.
pub(super) fn order(
    dendrogram: &Dendrogram,
    distance: &impl Fn(usize, usize) -> f64,
) -> Vec<usize> {
    let Some(root) = dendrogram.root() else {
        return Vec::new();
    };
    let mut table = Table::of(dendrogram, distance);
    for index in 0..dendrogram.merges.len() {
        table.fill(dendrogram.items + index);
    }
    let places = table.places_in_order(root);
    places
        .iter()
        .map(|&place| table.layout.items[place])
        .collect()
}

/// A square matrix over places.
struct Square {
    side: usize,
    values: Vec<f64>,
}

impl Square {
    fn of(side: usize) -> Self {
        Self {
            side,
            values: vec![0.0; side * side],
        }
    }

    fn row(&self, row: usize, columns: &Range<usize>) -> &[f64] {
        &self.values[row * self.side..][columns.clone()]
    }

    fn at(&self, row: usize, column: usize) -> f64 {
        self.values[row * self.side + column]
    }

    fn set_pair(&mut self, row: usize, column: usize, value: f64) {
        self.values[row * self.side + column] = value;
        self.values[column * self.side + row] = value;
    }
}

struct Table<'a> {
    dendrogram: &'a Dendrogram,
    layout: Layout,
    distances: Square,
    /// The least cost of the smallest cluster that holds both places, with them at its two ends.
    costs: Square,
}

impl<'a> Table<'a> {
    fn of(dendrogram: &'a Dendrogram, distance: &impl Fn(usize, usize) -> f64) -> Self {
        let layout = Layout::of(dendrogram);
        let side = dendrogram.items;
        let mut distances = Square::of(side);
        for row in 0..side {
            for column in row + 1..side {
                let value = distance(layout.items[row], layout.items[column]);
                distances.set_pair(row, column, value);
            }
        }
        Self {
            dendrogram,
            layout,
            distances,
            costs: Square::of(side),
        }
    }

    /// The costs of a cluster whose children's are known.
    fn fill(&mut self, cluster: usize) {
        let Some((left, right)) = self.dendrogram.children(cluster) else {
            return;
        };
        let columns = self.layout.places[right].clone();
        let mut to_inner = vec![0.0; columns.len()];
        let mut to_outer = vec![0.0; columns.len()];
        for outer in self.layout.places[left].clone() {
            to_inner.fill(f64::INFINITY);
            for inner in self.opposite(left, outer) {
                let cost = self.costs.at(outer, inner);
                lower(&mut to_inner, cost, self.distances.row(inner, &columns));
            }
            to_outer.fill(f64::INFINITY);
            for inner in columns.clone() {
                let far = self.opposite(right, inner);
                let range = far.start - columns.start..far.end - columns.start;
                let cost = to_inner[inner - columns.start];
                lower(&mut to_outer[range], cost, self.costs.row(inner, &far));
            }
            for (place, &cost) in columns.clone().zip(&to_outer) {
                self.costs.set_pair(outer, place, cost);
            }
        }
    }

    /// The places that can be the other end of `cluster` when `end` is one: those of the child it does
    /// not lie in; itself in a cluster of one.
    fn opposite(&self, cluster: usize, end: usize) -> Range<usize> {
        let Some((left, right)) = self.dendrogram.children(cluster) else {
            return end..end + 1;
        };
        let places = &self.layout.places;
        let other = if places[left].contains(&end) {
            right
        } else {
            left
        };
        places[other].clone()
    }

    /// The places of the root's cheapest order.
    fn places_in_order(&self, root: usize) -> Vec<usize> {
        let mut order = Vec::with_capacity(self.dendrogram.items);
        let (first, last) = self.best_ends(root);
        let mut waiting = vec![(root, first, last)];
        while let Some((cluster, first, last)) = waiting.pop() {
            match self.dendrogram.children(cluster) {
                None => order.push(first),
                Some((left, right)) => {
                    let starts_left = self.layout.places[left].contains(&first);
                    let (one, other) = if starts_left {
                        (left, right)
                    } else {
                        (right, left)
                    };
                    let (inner, next) = self.best_middle(one, other, first, last);
                    waiting.push((other, next, last));
                    waiting.push((one, first, inner));
                }
            }
        }
        order
    }

    fn best_ends(&self, root: usize) -> (usize, usize) {
        let Some((left, right)) = self.dendrogram.children(root) else {
            return (0, 0);
        };
        let places = &self.layout.places;
        self.least(&places[left], &places[right], |first, last| {
            self.costs.at(first, last)
        })
    }

    /// Where cluster `one`, begun at `first`, ends and `other`, ended at `last`, begins.
    fn best_middle(&self, one: usize, other: usize, first: usize, last: usize) -> (usize, usize) {
        let inner = self.opposite(one, first);
        let next = self.opposite(other, last);
        self.least(&inner, &next, |inner, next| {
            self.costs.at(first, inner) + self.distances.at(inner, next) + self.costs.at(next, last)
        })
    }

    fn least(
        &self,
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
}

/// Lowers every `into` to `cost` + its part of `row` where that is less.
fn lower(into: &mut [f64], cost: f64, row: &[f64]) {
    for (value, &part) in into.iter_mut().zip(row) {
        let sum = cost + part;
        *value = if sum < *value { sum } else { *value };
    }
}
