//! Clusters near each other in; the nearest of them to a given one out.

use super::components::PARTS;
use crate::feature::{FEATURE_LENGTH, Vector};
use crate::linkage::best::Best;
use wide::f64x4;

/// Clusters of a block.
pub(super) const LANES: usize = 32;

/// Clusters looked at in one instruction.
const WIDTH: usize = 4;

/// More than rounding can add to a distance.
const CAUTION: f64 = 1.0 + 1e-12;

/// A cluster.
#[derive(Clone, Copy, Debug)]
pub(super) struct Member {
    pub(super) slot: usize,
    pub(super) items: f64,
    pub(super) centroid: Vector,
}

impl Member {
    /// One item.
    pub(super) fn alone(slot: usize, vector: Vector) -> Self {
        Self {
            slot,
            items: 1.0,
            centroid: vector,
        }
    }

    /// The union of two clusters. Equal centroids stay exactly where they are.
    pub(super) fn merged(&self, other: &Self, slot: usize) -> Self {
        let items = self.items + other.items;
        let part = self.items / items;
        let (one, two) = (&self.centroid, &other.centroid);
        Self {
            slot,
            items,
            centroid: std::array::from_fn(|k| two[k] + (one[k] - two[k]) * part),
        }
    }

    /// Ward's distance, squared.
    pub(super) fn squared_distance(&self, other: &Self) -> f64 {
        let mut sum = 0.0;
        for (a, b) in self.centroid.iter().zip(&other.centroid) {
            sum += (a - b) * (a - b);
        }
        2.0 * self.items * other.items / (self.items + other.items) * sum
    }
}

/// Up to `LANES` clusters side by side; those gone lie at infinity.
pub(super) struct Block {
    centroids: [[f64x4; LANES / WIDTH]; FEATURE_LENGTH],
    items: [f64x4; LANES / WIDTH],
    slots: [usize; LANES],
    alive: [bool; LANES],
}

impl Block {
    pub(super) fn of(members: &[Member]) -> Self {
        let mut block = Self {
            centroids: [[f64x4::splat(f64::INFINITY); LANES / WIDTH]; FEATURE_LENGTH],
            items: [f64x4::splat(1.0); LANES / WIDTH],
            slots: [0; LANES],
            alive: [false; LANES],
        };
        for (lane, member) in members.iter().enumerate() {
            block.put(lane, Some(member));
        }
        block
    }

    /// Replaces the cluster of a lane.
    pub(super) fn put(&mut self, lane: usize, member: Option<&Member>) {
        let (vector, part) = (lane / WIDTH, lane % WIDTH);
        self.alive[lane] = member.is_some();
        self.slots[lane] = member.map_or(0, |member| member.slot);
        set(
            &mut self.items[vector],
            part,
            member.map_or(1.0, |member| member.items),
        );
        for k in 0..FEATURE_LENGTH {
            let value = member.map_or(f64::INFINITY, |member| member.centroid[k]);
            set(&mut self.centroids[k][vector], part, value);
        }
    }

    pub(super) fn member(&self, lane: usize) -> Member {
        let (vector, part) = (lane / WIDTH, lane % WIDTH);
        Member {
            slot: self.slots[lane],
            items: self.items[vector].to_array()[part],
            centroid: std::array::from_fn(|k| self.centroids[k][vector].to_array()[part]),
        }
    }

    /// The clusters that are not gone.
    pub(super) fn members(&self) -> impl Iterator<Item = Member> + '_ {
        let lanes = (0..LANES).filter(|&lane| self.alive[lane]);
        lanes.map(|lane| self.member(lane))
    }

    /// Offers every other cluster of the block that is as near as the best so far.
    pub(super) fn search(&self, from: &Member, best: &mut Best) {
        for vector in 0..LANES / WIDTH {
            let Some(distances) = self.squared_distances(vector, from, best.distance) else {
                continue;
            };
            for (part, &distance) in distances.to_array().iter().enumerate() {
                let slot = self.slots[vector * WIDTH + part];
                if distance <= best.distance && slot != from.slot {
                    best.offer(slot, distance);
                }
            }
        }
    }

    /// The operations of [`Member::squared_distance`], for the same bits; none where all are above
    /// `enough`.
    fn squared_distances(&self, vector: usize, from: &Member, enough: f64) -> Option<f64x4> {
        let items = self.items[vector];
        let (twice_both, both) = (items * (2.0 * from.items), items + from.items);
        let limit = both * (enough * CAUTION);
        let mut sum = f64x4::splat(0.0);
        for parts in PARTS {
            for k in parts {
                let apart = f64x4::splat(from.centroid[k]) - self.centroids[k][vector];
                sum += apart * apart;
            }
            if (twice_both * sum).simd_gt(limit).all() {
                return None;
            }
        }
        Some(twice_both / both * sum)
    }
}

fn set(vector: &mut f64x4, part: usize, value: f64) {
    let mut values = vector.to_array();
    values[part] = value;
    *vector = f64x4::from(values);
}
