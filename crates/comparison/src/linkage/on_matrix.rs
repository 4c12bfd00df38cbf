//! Clusters known by the distances between them alone (Lance and Williams 1967).

use super::best::Best;
use super::chain::{Clusters, Near};
use crate::condensed::{Condensed, Keeping};
use std::marker::PhantomData;

/// Two clusters that merge: their distance and how many items each holds.
pub(super) struct Join {
    between: f64,
    low: f64,
    high: f64,
}

/// How far a third cluster is from the union of two.
pub(super) trait Rule {
    /// From the distances to the two, and the items of the third.
    fn distance(join: &Join, from_low: f64, from_high: f64, third: f64) -> f64;
}

/// Ward's rule on distances, not their squares; the operations in SciPy's order, for the same bits.
pub(super) struct WardRule;

impl Rule for WardRule {
    fn distance(join: &Join, from_low: f64, from_high: f64, third: f64) -> f64 {
        let t = 1.0 / (join.low + join.high + third);
        let from_low = (third + join.low) * t * from_low * from_low;
        let from_high = (third + join.high) * t * from_high * from_high;
        let between = third * t * join.between * join.between;
        (from_low + from_high - between).sqrt()
    }
}

/// The mean over the pairs of items.
pub(super) struct GroupAverageRule;

impl Rule for GroupAverageRule {
    fn distance(join: &Join, from_low: f64, from_high: f64, _third: f64) -> f64 {
        (join.low * from_low + join.high * from_high) / (join.low + join.high)
    }
}

/// The position of a cluster that is gone.
const GONE: usize = usize::MAX;

/// Clusters over their own copy of a matrix, from which those gone are dropped now and then.
pub(super) struct OnMatrix<R> {
    /// Distances between positions.
    distances: Condensed,
    /// Items of the cluster at every position, 0 where it is gone.
    sizes: Vec<f64>,
    /// The slot of every position.
    slots: Vec<usize>,
    /// The position of every slot.
    positions: Vec<usize>,
    alive: usize,
    /// Those gone on their way out.
    dropping: Option<Keeping>,
    rule: PhantomData<R>,
}

impl<R: Rule> OnMatrix<R> {
    pub(super) fn of(distances: Condensed) -> Self {
        let items = distances.items;
        Self {
            sizes: vec![1.0; items],
            slots: (0..items).collect(),
            positions: (0..items).collect(),
            alive: items,
            dropping: None,
            distances,
            rule: PhantomData,
        }
    }

    /// The memory of the matrix.
    pub(super) fn into_room(self) -> Vec<f64> {
        self.distances.values
    }

    /// Numbers the clusters that are left anew, once their distances have been moved together.
    fn renumber(&mut self, kept: &[usize]) {
        self.sizes = kept.iter().map(|&at| self.sizes[at]).collect();
        self.slots = kept.iter().map(|&at| self.slots[at]).collect();
        for (position, &slot) in self.slots.iter().enumerate() {
            self.positions[slot] = position;
        }
    }

    /// The distances of the clusters before both; those gone get any.
    fn join_before(&mut self, low: usize, high: usize, join: &Join) {
        for (place, &third) in self.distances.column(low).zip(&self.sizes) {
            let values = &mut self.distances.values;
            let from_high = values[place + high - low];
            values[place] = R::distance(join, values[place], from_high, third);
        }
    }

    fn join_between(&mut self, low: usize, high: usize, join: &Join) {
        let places = self.distances.column(high).zip(&self.sizes).skip(low + 1);
        for ((place, &third), into) in places.zip(self.distances.row(low)) {
            let values = &mut self.distances.values;
            values[into] = R::distance(join, values[into], values[place], third);
        }
    }

    fn join_after(&mut self, low: usize, high: usize, join: &Join) {
        let (row, start) = (self.distances.row(low), self.distances.row(high).start);
        let (before, from_high) = self.distances.values.split_at_mut(start);
        let from_low = &mut before[row.start + high - low..];
        let thirds = &self.sizes[high + 1..];
        for ((low, &high), &third) in from_low.iter_mut().zip(&*from_high).zip(thirds) {
            *low = R::distance(join, *low, high, third);
        }
    }

    /// The lowest other slot, for distances that are no numbers.
    fn first_other(&self, slot: usize) -> usize {
        let mut others = (0..self.positions.len()).filter(|&at| at != slot && self.holds(at));
        others.next().unwrap_or(slot)
    }
}

impl<R: Rule> Clusters for OnMatrix<R> {
    fn slots(&self) -> usize {
        self.positions.len()
    }

    fn holds(&self, slot: usize) -> bool {
        self.positions[slot] != GONE
    }

    fn nearest(&mut self, slot: usize, previous: Option<usize>) -> Near {
        let position = self.positions[slot];
        let mut best = previous.map_or(Best::none(), |previous| {
            Best::preferred(
                previous,
                self.distances.at(position, self.positions[previous]),
            )
        });
        for (other, place) in self.distances.column(position).enumerate() {
            let distance = self.distances.values[place];
            if distance <= best.distance && self.sizes[other] > 0.0 {
                best.offer(self.slots[other], distance);
            }
        }
        let after = self.distances.values[self.distances.row(position)].iter();
        for (other, &distance) in (position + 1..).zip(after) {
            if distance <= best.distance && self.sizes[other] > 0.0 {
                best.offer(self.slots[other], distance);
            }
        }
        Near {
            slot: best.slot.unwrap_or_else(|| self.first_other(slot)),
            distance: best.distance,
        }
    }

    fn join(&mut self, gone: usize, kept: usize, distance: f64) {
        let (one, other) = (self.positions[gone], self.positions[kept]);
        let (low, high) = (one.min(other), one.max(other));
        let join = Join {
            between: distance,
            low: self.sizes[low],
            high: self.sizes[high],
        };
        self.join_before(low, high, &join);
        self.join_between(low, high, &join);
        self.join_after(low, high, &join);
        self.sizes[high] = 0.0;
        self.sizes[low] = join.low + join.high;
        self.slots[low] = kept;
        self.positions[kept] = low;
        self.positions[gone] = GONE;
        self.alive -= 1;
        if 4 * self.alive <= 3 * self.slots.len() {
            let positions = 0..self.slots.len();
            let kept = positions.filter(|&at| self.sizes[at] > 0.0);
            self.dropping = Some(Keeping::new(kept.collect()));
        }
    }

    fn settle(&mut self, budget: usize) -> bool {
        let Some(mut dropping) = self.dropping.take() else {
            return true;
        };
        if dropping.step(&mut self.distances, budget) {
            self.renumber(dropping.kept());
            return true;
        }
        self.dropping = Some(dropping);
        false
    }
}
