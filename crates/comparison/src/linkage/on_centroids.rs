//! Clusters known by their centroids: the memory grows with the items, not with their pairs.
//!
//! Clusters near each other share a block with a box around it; a search for the nearest one passes
//! by blocks whose box is too far. What is found does not depend on the blocks.

mod block;
mod boxes;
mod components;
mod near_blocks;

use super::best::Best;
use super::chain::{Clusters, Near};
use crate::feature::Vector;
use block::{Block, LANES, Member};
use boxes::Boxes;

/// The place of a cluster that is gone.
const GONE: usize = usize::MAX;

/// Clusters in blocks.
pub(super) struct OnCentroids {
    blocks: Vec<Block>,
    boxes: Boxes,
    /// Block · `LANES` + lane of the cluster in every slot.
    places: Vec<usize>,
    alive: usize,
    /// How many were alive when the blocks were last made.
    laid_out: usize,
}

impl OnCentroids {
    pub(super) fn of(vectors: &[Vector]) -> Self {
        let mut clusters = Self {
            blocks: Vec::new(),
            boxes: Boxes::of(&[]),
            places: vec![GONE; vectors.len()],
            alive: vectors.len(),
            laid_out: 0,
        };
        let order = components::widest_first(vectors);
        let ordered = |vector: &Vector| order.map(|k| vector[k]);
        let members = vectors.iter().enumerate();
        clusters.lay_out(
            members
                .map(|(slot, vector)| Member::alone(slot, ordered(vector)))
                .collect(),
        );
        clusters
    }

    /// Puts clusters into new blocks.
    fn lay_out(&mut self, mut members: Vec<Member>) {
        near_blocks::sort(&mut members);
        for (place, member) in members.iter().enumerate() {
            self.places[member.slot] = place;
        }
        self.laid_out = members.len();
        self.blocks = members.chunks(LANES).map(Block::of).collect();
        self.boxes = Boxes::of(&self.blocks);
    }

    fn member(&self, slot: usize) -> Member {
        let place = self.places[slot];
        self.blocks[place / LANES].member(place % LANES)
    }

    fn put(&mut self, place: usize, member: Option<&Member>) {
        let block = place / LANES;
        self.blocks[block].put(place % LANES, member);
        self.boxes.renew(block, &self.blocks[block]);
    }

    /// Any other cluster, for distances that are no numbers.
    fn first_other(&self, slot: usize) -> usize {
        let others = self.places.iter().enumerate();
        let mut alive = others.filter(|&(other, &place)| other != slot && place != GONE);
        alive.next().map_or(slot, |(other, _)| other)
    }
}

impl Clusters for OnCentroids {
    fn slots(&self) -> usize {
        self.places.len()
    }

    fn holds(&self, slot: usize) -> bool {
        self.places[slot] != GONE
    }

    fn nearest(&mut self, slot: usize, previous: Option<usize>) -> Near {
        let from = self.member(slot);
        let mut best = match previous {
            Some(previous) => {
                Best::preferred(previous, from.squared_distance(&self.member(previous)))
            }
            None => Best::none(),
        };
        let own = self.places[slot] / LANES;
        self.blocks[own].search(&from, &mut best);
        for group in 0..self.boxes.groups() {
            let mut near = self.boxes.near(group, &from, best.distance);
            while near != 0 {
                let block = group * 4 + near.trailing_zeros() as usize;
                near &= near - 1;
                if block != own && block < self.blocks.len() {
                    self.blocks[block].search(&from, &mut best);
                }
            }
        }
        Near {
            slot: best.slot.unwrap_or_else(|| self.first_other(slot)),
            distance: best.distance.sqrt(),
        }
    }

    fn join(&mut self, gone: usize, kept: usize, _distance: f64) {
        let (one, other) = (self.member(gone), self.member(kept));
        let merged = one.merged(&other, kept);
        let (freed, place) = if one.items > other.items {
            (self.places[kept], self.places[gone])
        } else {
            (self.places[gone], self.places[kept])
        };
        self.put(freed, None);
        self.put(place, Some(&merged));
        self.places[gone] = GONE;
        self.places[kept] = place;
        self.alive -= 1;
        if 2 * self.alive <= self.laid_out && self.laid_out > LANES {
            let members = self.blocks.iter().flat_map(Block::members).collect();
            self.lay_out(members);
        }
    }
}
