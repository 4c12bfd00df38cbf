//! A tree and the distances of its leaves in; the order of the leaves out that the matrix is shown in.

mod exact;
mod layout;
mod least_sums;
mod square;
mod top;
mod turning;

use crate::dendrogram::Dendrogram;
use exact::Table;
use layout::Layout;
use top::Top;
use turning::Turning;

/// Up to so many leaves the order is the best there is.
pub const MOST_OPTIMAL_LEAVES: usize = 1_000;

/// Sums of the dynamic programming that take as long as a distance, about.
const SUMS_OF_A_DISTANCE: usize = 32;

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
    /// Subtrees whose distances from all later ones are known.
    rows: usize,
    /// Merges of subtrees whose costs are known.
    merges: usize,
    spent: usize,
    work: usize,
}

impl OrderSteps {
    /// Nothing ordered yet.
    #[must_use]
    pub fn new(dendrogram: &Dendrogram) -> Self {
        let top = Top::of(dendrogram, MOST_OPTIMAL_LEAVES);
        let table = Table::of(top.tree);
        let sums: usize = (0..table.merges()).map(|merge| table.sums(merge)).sum();
        let pairs = dendrogram.items * dendrogram.items / 2;
        Self {
            dendrogram: dendrogram.clone(),
            layout: Layout::of(dendrogram),
            subtrees: top.subtrees,
            table,
            rows: 0,
            merges: 0,
            spent: 0,
            work: pairs + sums / SUMS_OF_A_DISTANCE,
        }
    }

    /// Goes on for the time of about `budget` distances; how much is done, 0 to 1.
    pub fn step(&mut self, budget: usize, distance: &impl Fn(usize, usize) -> f64) -> f64 {
        let until = self.spent.saturating_add(budget);
        while self.spent < until && self.is_open() {
            self.spent += self.advance(distance);
        }
        if self.is_open() {
            (self.spent as f64 / self.work as f64).min(1.0)
        } else {
            1.0
        }
    }

    /// Does what is left; the order.
    #[must_use]
    pub fn finish(mut self, distance: &impl Fn(usize, usize) -> f64) -> Order {
        self.step(usize::MAX, distance);
        let order = self.table.order();
        let subtrees: Vec<usize> = order.iter().map(|&leaf| self.subtrees[leaf]).collect();
        let turning = Turning {
            dendrogram: &self.dendrogram,
            layout: &self.layout,
            distance,
        };
        let mut leaves = turning.leaves(&subtrees);
        if leaves.first() > leaves.last() {
            leaves.reverse();
        }
        Order {
            leaves,
            optimal: self.subtrees.len() == self.dendrogram.items,
        }
    }

    fn is_open(&self) -> bool {
        self.merges < self.table.merges()
    }

    /// The next row of distances, or else the next merge; what it took.
    fn advance(&mut self, distance: &impl Fn(usize, usize) -> f64) -> usize {
        if self.rows < self.table.leaves() {
            self.rows += 1;
            return self.measure(self.rows - 1, distance);
        }
        self.table.fill(self.merges);
        self.merges += 1;
        1 + self.table.sums(self.merges - 1) / SUMS_OF_A_DISTANCE
    }

    /// The mean distances of the subtree at a place from those at later places.
    fn measure(&mut self, row: usize, distance: &impl Fn(usize, usize) -> f64) -> usize {
        let mut spent = 1;
        for column in row + 1..self.table.leaves() {
            let (one, other) = (self.items_at(row), self.items_at(column));
            let pairs = one.iter().flat_map(|&a| other.iter().map(move |&b| (a, b)));
            let sum: f64 = pairs.map(|(a, b)| distance(a, b)).sum();
            let count = one.len() * other.len();
            spent += count;
            self.table
                .distances
                .set_pair(row, column, sum / count as f64);
        }
        spent
    }

    /// The items of the subtree at a place of the top.
    fn items_at(&self, place: usize) -> &[usize] {
        let subtree = self.subtrees[self.table.leaf(place)];
        &self.layout.items[self.layout.places[subtree].clone()]
    }
}
