//! A tree and the distances of its leaves in; the order of the leaves out that the matrix is shown in.

mod exact;
mod layout;
mod least_sums;
mod square;
mod top;
mod turning;

use crate::condensed;
use crate::dendrogram::Dendrogram;
use exact::Table;
use layout::Layout;
use top::Top;
use turning::{Turning, Ways};

/// Up to so many leaves the order is the best there is.
pub const MOST_OPTIMAL_LEAVES: usize = 1_000;

/// Sums of the dynamic programming that take as long as a distance, about.
const SUMS_OF_A_DISTANCE: usize = 32;

/// So many rows of costs are found together at least: they share what is laid out for them.
const FEWEST_ROWS: usize = 16;

/// What is done is estimated: less than all, as long as anything is left.
const ALMOST: f64 = 0.999;

/// The leaves of a tree in a row.
#[derive(Clone, Debug, PartialEq)]
pub struct Order {
    /// The items, each once.
    pub leaves: Vec<usize>,
    /// Whether no order that the tree allows has a lower cost.
    pub optimal: bool,
}

/// The order, among those that turn the branches of the tree, with the least sum of distances between
/// neighbours (Bar-Joseph, Gifford and Jaakkola 2001). Read in the direction in which the lower of the
/// two end items comes first.
///
/// Of more than [`MOST_OPTIMAL_LEAVES`] the top of the tree, with so many subtrees, is ordered by
/// their mean distances, and inside them the side nearer to the neighbour is turned outward.
pub fn optimal(dendrogram: &Dendrogram, distance: &impl Fn(usize, usize) -> f64) -> Order {
    OrderSteps::new(dendrogram).finish(distance)
}

/// The sum of the distances between neighbours.
pub fn cost(leaves: &[usize], distance: &impl Fn(usize, usize) -> f64) -> f64 {
    let pairs = leaves.windows(2);
    pairs.map(|pair| distance(pair[0], pair[1])).sum()
}

/// [`optimal`] in pieces. Every call takes the same distance.
pub struct OrderSteps {
    dendrogram: Dendrogram,
    layout: Layout,
    subtrees: Vec<usize>,
    table: Table,
    /// The mean distance under way, of the subtrees at two places.
    mean: Mean,
    /// Merges of subtrees whose costs are known, and rows of the next.
    merges: usize,
    rows: usize,
    turning: Option<Turning>,
    spent: usize,
    work: usize,
}

/// A sum over the pairs of items of two subtrees, so far; before it come those of earlier rows, and
/// those of the same row in earlier columns.
struct Mean {
    row: usize,
    column: usize,
    /// Items of the first subtree that are summed up.
    items: usize,
    sum: f64,
}

impl OrderSteps {
    /// Nothing ordered yet.
    #[must_use]
    pub fn new(dendrogram: &Dendrogram) -> Self {
        let top = Top::of(dendrogram, MOST_OPTIMAL_LEAVES);
        let table = Table::of(top.tree);
        let sums = |merge: usize| table.rows(merge).len() * table.sums_of_a_row(merge);
        let sums: usize = (0..table.merges()).map(sums).sum();
        Self {
            dendrogram: dendrogram.clone(),
            layout: Layout::of(dendrogram),
            subtrees: top.subtrees,
            mean: Mean::between(0, 1),
            merges: 0,
            rows: 0,
            turning: None,
            spent: 0,
            work: condensed::pairs(dendrogram.items) + sums / SUMS_OF_A_DISTANCE,
            table,
        }
    }

    /// Goes on for the time of about `budget` distances; how much is done, 0 to 1.
    pub fn step(&mut self, budget: usize, distance: &impl Fn(usize, usize) -> f64) -> f64 {
        let until = self.spent.saturating_add(budget);
        while self.spent < until && self.is_open() {
            self.spent += self.advance(until - self.spent, distance);
        }
        match self.is_open() {
            true => (self.spent as f64 / self.work as f64).min(ALMOST),
            false => 1.0,
        }
    }

    /// Does what is left; the order.
    #[must_use]
    pub fn finish(mut self, distance: &impl Fn(usize, usize) -> f64) -> Order {
        while self.is_open() {
            self.step(usize::MAX, distance);
        }
        let mut leaves = self.turning.map_or(Vec::new(), Turning::finish);
        if leaves.first() > leaves.last() {
            leaves.reverse();
        }
        Order {
            leaves,
            optimal: self.subtrees.len() == self.dendrogram.items,
        }
    }

    fn is_open(&self) -> bool {
        self.turning.as_ref().is_none_or(Turning::is_open)
    }

    /// A part of the distances, or else of the costs, or else of the turning; what it took.
    fn advance(&mut self, budget: usize, distance: &impl Fn(usize, usize) -> f64) -> usize {
        if self.mean.column < self.table.leaves() {
            return self.measure(distance);
        }
        if self.merges < self.table.merges() {
            return self.fill(budget);
        }
        let turning = self.turning.get_or_insert_with(|| {
            let order = self.table.order();
            let subtrees: Vec<usize> = order.iter().map(|&leaf| self.subtrees[leaf]).collect();
            Turning::new(&subtrees)
        });
        turning.advance(&Ways {
            dendrogram: &self.dendrogram,
            layout: &self.layout,
            distance,
        })
    }

    /// Sums up the distances of the next item of a subtree from the items of a later one.
    fn measure(&mut self, distance: &impl Fn(usize, usize) -> f64) -> usize {
        let Mean { row, column, .. } = self.mean;
        let (one, other) = (self.items_at(row), self.items_at(column));
        let (a, count) = (one[self.mean.items], one.len() * other.len());
        let sum = other
            .iter()
            .fold(self.mean.sum, |sum, &b| sum + distance(a, b));
        let (spent, is_whole) = (1 + other.len(), self.mean.items + 1 == one.len());
        self.mean.sum = sum;
        self.mean.items += 1;
        if is_whole {
            let mean = sum / count as f64;
            self.table.distances.set_pair(row, column, mean);
            self.mean = match column + 1 < self.table.leaves() {
                true => Mean::between(row, column + 1),
                false => Mean::between(row + 1, row + 2),
            };
        }
        spent
    }

    /// Fills in some rows of the next merge.
    fn fill(&mut self, budget: usize) -> usize {
        let all = self.table.rows(self.merges);
        let of_a_row = 1 + self.table.sums_of_a_row(self.merges) / SUMS_OF_A_DISTANCE;
        let count = (budget / of_a_row).clamp(FEWEST_ROWS, all.len().max(FEWEST_ROWS));
        let start = all.start + self.rows;
        let end = all.end.min(start + count);
        self.table.fill(self.merges, &(start..end));
        self.rows += end - start;
        if end == all.end {
            self.merges += 1;
            self.rows = 0;
        }
        (end - start) * of_a_row
    }

    /// The items of the subtree at a place of the top.
    fn items_at(&self, place: usize) -> &[usize] {
        let subtree = self.subtrees[self.table.leaf(place)];
        &self.layout.items[self.layout.places[subtree].clone()]
    }
}

impl Mean {
    fn between(row: usize, column: usize) -> Self {
        Self {
            row,
            column,
            items: 0,
            sum: 0.0,
        }
    }
}
