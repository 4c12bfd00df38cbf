//! Clusters known by the distances between them alone (Lance and Williams 1967).

use super::chain::{Clusters, Near};
use crate::condensed::Condensed;
use std::marker::PhantomData;

/// The distances of a third cluster from two and of the two, and how many items each holds.
pub(super) struct Triple {
    from_gone: f64,
    from_kept: f64,
    between: f64,
    gone: f64,
    kept: f64,
    third: f64,
}

/// How far a third cluster is from the union of two.
pub(super) trait Rule {
    fn distance(triple: &Triple) -> f64;
}

/// Ward's rule on distances, not their squares; the operations in SciPy's order, for the same bits.
pub(super) struct WardRule;

impl Rule for WardRule {
    fn distance(triple: &Triple) -> f64 {
        let t = 1.0 / (triple.gone + triple.kept + triple.third);
        let from_gone = (triple.third + triple.gone) * t * triple.from_gone * triple.from_gone;
        let from_kept = (triple.third + triple.kept) * t * triple.from_kept * triple.from_kept;
        let between = triple.third * t * triple.between * triple.between;
        (from_gone + from_kept - between).sqrt()
    }
}

/// The mean over the pairs of items.
pub(super) struct GroupAverageRule;

impl Rule for GroupAverageRule {
    fn distance(triple: &Triple) -> f64 {
        let sum = triple.gone * triple.from_gone + triple.kept * triple.from_kept;
        sum / (triple.gone + triple.kept)
    }
}

/// Clusters over their own copy of a matrix.
pub(super) struct OnMatrix<R> {
    distances: Condensed,
    /// Items in every slot, 0 where the cluster is gone.
    sizes: Vec<usize>,
    rule: PhantomData<R>,
}

impl<R: Rule> OnMatrix<R> {
    pub(super) fn of(distances: Condensed) -> Self {
        Self {
            sizes: vec![1; distances.items],
            distances,
            rule: PhantomData,
        }
    }

    fn others(&self, slot: usize) -> impl Iterator<Item = usize> + '_ {
        (0..self.sizes.len()).filter(move |&other| other != slot && self.sizes[other] > 0)
    }
}

impl<R: Rule> Clusters for OnMatrix<R> {
    fn slots(&self) -> usize {
        self.sizes.len()
    }

    fn holds(&self, slot: usize) -> bool {
        self.sizes[slot] > 0
    }

    fn nearest(&mut self, slot: usize, previous: Option<usize>) -> Near {
        let first = previous
            .or_else(|| self.others(slot).next())
            .unwrap_or(slot);
        let mut near = Near {
            slot: first,
            distance: self.distances.at(slot, first),
        };
        for other in self.others(slot) {
            let distance = self.distances.at(slot, other);
            if distance < near.distance {
                near = Near {
                    slot: other,
                    distance,
                };
            }
        }
        near
    }

    fn join(&mut self, gone: usize, kept: usize, distance: f64) {
        let (gone_size, kept_size) = (self.sizes[gone], self.sizes[kept]);
        self.sizes[gone] = 0;
        for third in 0..self.sizes.len() {
            if third == kept || self.sizes[third] == 0 {
                continue;
            }
            let triple = Triple {
                from_gone: self.distances.at(gone, third),
                from_kept: self.distances.at(kept, third),
                between: distance,
                gone: gone_size as f64,
                kept: kept_size as f64,
                third: self.sizes[third] as f64,
            };
            *self.distances.at_mut(kept, third) = R::distance(&triple);
        }
        self.sizes[kept] = gone_size + kept_size;
    }
}
