//! Blocks of clusters in; a bound out, below which none of a block's distances from a cluster lies.

use super::block::{Block, Member};
use super::components::PARTS;
use crate::feature::FEATURE_LENGTH;
use wide::f64x4;

/// Blocks whose bounds are found in one instruction.
const WIDTH: usize = 4;

/// Takes from a bound what rounding could add to it.
const CAUTION: f64 = 1.0 - 1e-12;

/// The boxes of four blocks.
struct Group {
    lows: [[f64; WIDTH]; FEATURE_LENGTH],
    highs: [[f64; WIDTH]; FEATURE_LENGTH],
    /// The items of the smallest cluster of every block.
    fewest: [f64; WIDTH],
}

/// The boxes around the centroids of all blocks.
pub(super) struct Boxes {
    groups: Vec<Group>,
}

impl Boxes {
    pub(super) fn of(blocks: &[Block]) -> Self {
        let empty = || Group {
            lows: [[f64::INFINITY; WIDTH]; FEATURE_LENGTH],
            highs: [[f64::NEG_INFINITY; WIDTH]; FEATURE_LENGTH],
            fewest: [1.0; WIDTH],
        };
        let count = blocks.len().div_ceil(WIDTH);
        let mut boxes = Self {
            groups: std::iter::repeat_with(empty).take(count).collect(),
        };
        for (index, block) in blocks.iter().enumerate() {
            boxes.renew(index, block);
        }
        boxes
    }

    pub(super) fn groups(&self) -> usize {
        self.groups.len()
    }

    /// Draws the box of a block anew; that of an empty one is infinitely far.
    pub(super) fn renew(&mut self, index: usize, block: &Block) {
        let (group, lane) = (&mut self.groups[index / WIDTH], index % WIDTH);
        for k in 0..FEATURE_LENGTH {
            group.lows[k][lane] = f64::INFINITY;
            group.highs[k][lane] = f64::NEG_INFINITY;
        }
        let mut fewest = f64::INFINITY;
        for member in block.members() {
            fewest = fewest.min(member.items);
            for k in 0..FEATURE_LENGTH {
                group.lows[k][lane] = group.lows[k][lane].min(member.centroid[k]);
                group.highs[k][lane] = group.highs[k][lane].max(member.centroid[k]);
            }
        }
        group.fewest[lane] = if fewest.is_finite() { fewest } else { 1.0 };
    }

    /// Blocks of a group that may hold a cluster as near as `enough`, a squared distance; bit by bit.
    pub(super) fn near(&self, group: usize, from: &Member, enough: f64) -> u32 {
        let group = &self.groups[group];
        let (own, items) = (f64x4::splat(from.items), f64x4::from(group.fewest));
        let weight = f64x4::splat(2.0 * from.items * CAUTION) * items / (own + items);
        let mut bound = f64x4::splat(0.0);
        for parts in PARTS {
            for k in parts {
                let gap = group.gap(k, from.centroid[k]);
                bound += gap * gap;
            }
            if (weight * bound).simd_gt(enough).all() {
                return 0;
            }
        }
        (weight * bound).simd_le(enough).to_bitmask()
    }
}

impl Group {
    /// How far a coordinate is outside the boxes.
    fn gap(&self, k: usize, coordinate: f64) -> f64x4 {
        let place = f64x4::splat(coordinate);
        let below = f64x4::from(self.lows[k]) - place;
        let above = place - f64x4::from(self.highs[k]);
        below.fast_max(above).fast_max(f64x4::splat(0.0))
    }
}
