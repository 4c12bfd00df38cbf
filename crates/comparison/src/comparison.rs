//! A set of clips compared: what is asked of it goes in, cuts, neighbours and places among all pairs
//! come out. Items are the clips, from 0 in their order.

use core::fmt::{self, Display, Formatter};
use std::rc::Rc;

use crate::condensed::TooManyPairs;
use crate::dendrogram::Dendrogram;
use crate::distance::Measured;
use crate::distances::Distances;
use crate::evaluation::{OneNearest, OneNearestRun, Scores};
use crate::explanation::{self, Explanation};
use crate::feature::{ClipFeature, Vector};
use crate::leaf_order::Order;
use crate::map::Map;
use crate::neighbours::nearest_first;
use crate::settings::{Settings, SettingsError};
use crate::spread::Spread;

/// One distance between all clips of a set, and what follows from it.
pub struct Comparison {
    /// What it was made with.
    pub settings: Settings,
    /// The clips.
    pub clips: Vec<Rc<ClipFeature>>,
    /// Their distances.
    pub distances: Distances,
    /// The tree of the clips.
    pub tree: Dendrogram,
    /// Its leaves in the order in which the matrix is shown.
    pub order: Order,
    /// How the distances are spread.
    pub spread: Spread,
    /// Where the clips lie in the plane.
    pub map: Map,
    /// How many clusters the rule of the settings finds.
    pub automatic_clusters: usize,
    /// The Bayesian information criterion of 1, 2, … clusters; empty where another rule cuts.
    pub bic: Vec<f64>,
}

/// Why clips cannot be compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CannotCompare {
    /// The settings do not go together.
    Settings(SettingsError),
    /// Memory for all pairs is needed, as by the group average.
    Memory(TooManyPairs),
}

impl From<SettingsError> for CannotCompare {
    fn from(error: SettingsError) -> Self {
        Self::Settings(error)
    }
}

impl From<TooManyPairs> for CannotCompare {
    fn from(error: TooManyPairs) -> Self {
        Self::Memory(error)
    }
}

impl Display for CannotCompare {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Settings(error) => error.fmt(f),
            Self::Memory(TooManyPairs { items, bytes }) => write!(
                f,
                "the group average of {items} clips needs {} MB of memory, more than there is: take Ward's method",
                bytes.div_ceil(1_000_000)
            ),
        }
    }
}

impl core::error::Error for CannotCompare {}

/// The partition at a cut.
#[derive(Clone, Debug, PartialEq)]
pub struct Cut {
    /// How many clusters there are.
    pub clusters: usize,
    /// The cluster of each item, from 0 in the order of the leaves.
    pub cluster_of_item: Vec<usize>,
    /// The height between the last merge below the cut and the first above it.
    pub height: f64,
}

/// A near clip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Neighbour {
    /// Which item it is.
    pub item: usize,
    /// How far it is.
    pub distance: f64,
    /// Whether it is its mirror image that is near.
    pub mirrored: bool,
}

/// How well the distance, and a cut, tell labels apart.
#[derive(Clone, Debug, PartialEq)]
pub struct Evaluation {
    /// Each clip held against the nearest other one.
    pub one_nearest: OneNearest,
    /// The cut held against the labels.
    pub scores: Scores,
}

impl Comparison {
    /// The partition into so many clusters, at least 1 and at most the number of items.
    pub fn cut(&self, clusters: usize) -> Cut {
        let clusters = clusters.max(1).min(self.clips.len());
        Cut {
            clusters,
            cluster_of_item: self.tree.cut_by_leaves(clusters, &self.order.leaves),
            height: self.tree.cut_height(clusters),
        }
    }

    /// What is compared of each clip.
    pub fn vectors(&self) -> Vec<Vector> {
        let distance = self.settings.distance;
        self.clips
            .iter()
            .map(|clip| *distance.vector(clip))
            .collect()
    }

    /// The distance of two items, and whether it is that to the mirror image of the second.
    pub fn between(&self, a: usize, b: usize) -> Measured {
        let distance = self.settings.distance;
        distance.between(&self.clips[a], &self.clips[b])
    }

    /// The items nearest to one, at most `most`, the nearest first; of equals the earlier.
    pub fn neighbours(&self, item: usize, most: usize) -> Vec<Neighbour> {
        let row = self.distances.row(item);
        let others = nearest_first(&row, item).into_iter().take(most);
        let neighbour = |other: usize| Neighbour {
            item: other,
            distance: row[other],
            mirrored: self.between(item, other).mirrored,
        };
        others.map(neighbour).collect()
    }

    /// Each labelled item held against the nearest other one; one label an item, or none at all. In
    /// pieces: [`OneNearestRun`].
    pub fn one_nearest(&self, labels: &[Option<usize>]) -> OneNearest {
        let mut run = OneNearestRun::new(labels.to_vec());
        while run.step(&self.distances, &self.spread, usize::MAX) < 1.0 {}
        run.finish()
    }

    /// Why two items differ.
    pub fn explain(&self, a: usize, b: usize) -> Explanation {
        explanation::explain(self.settings.distance, &self.clips[a], &self.clips[b])
    }
}
