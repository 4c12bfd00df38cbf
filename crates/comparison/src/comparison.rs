//! A set of clips compared: what is asked of it goes in, cuts, neighbours and places among all pairs
//! come out. Items are the clips, from 0 in their order.

use std::rc::Rc;

use crate::cut::{bic, mojena};
use crate::dendrogram::Dendrogram;
use crate::distance::Measured;
use crate::distances::Distances;
use crate::evaluation::{self, OneNearest, Scores};
use crate::explanation::{self, Explanation};
use crate::feature::{ClipFeature, Vector};
use crate::leaf_order::Order;
use crate::map::Map;
use crate::neighbours::nearest_first;
use crate::run::ComparisonRun;
use crate::settings::{CutRule, Settings, SettingsError};
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

/// Places of a pair, from 1, the most alike first; of equals all have the best.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ranks {
    /// Among all pairs.
    pub of_all: usize,
    /// Of the second among the neighbours of the first.
    pub from_a: usize,
    /// Of the first among the neighbours of the second.
    pub from_b: usize,
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
    /// Compares clips at once; in pieces: [`ComparisonRun`].
    ///
    /// # Errors
    /// Settings that do not go together.
    pub fn of(clips: Vec<Rc<ClipFeature>>, settings: Settings) -> Result<Self, SettingsError> {
        Ok(ComparisonRun::new(clips, settings)?.finish())
    }

    /// The partition into so many clusters (held within 1 and the number of items).
    pub fn cut(&self, clusters: usize) -> Cut {
        let clusters = clusters.clamp(1, self.clips.len().max(1));
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

    /// Each labelled item held against the nearest other one; one label an item.
    pub fn one_nearest(&self, labels: &[Option<usize>]) -> OneNearest {
        // All pairs of one item are asked for after each other: a row at once is quicker.
        let (mut of, mut row) = (usize::MAX, Vec::new());
        evaluation::leave_one_out(labels, |a, b| {
            if of != a {
                (of, row) = (a, self.distances.to_later(a));
            }
            row[b - a - 1]
        })
    }

    /// Why two items differ.
    pub fn explain(&self, a: usize, b: usize) -> Explanation {
        explanation::explain(self.settings.distance, &self.clips[a], &self.clips[b])
    }

    /// The places of two different items.
    pub fn ranks(&self, a: usize, b: usize) -> Ranks {
        let value = self.distances.at(a, b);
        let nearer = |row: Vec<f64>| row.iter().filter(|other| **other < value).count();
        let others_nearer = |item: usize| {
            let row = self.distances.row(item).into_iter().enumerate();
            let others = row.filter(|(other, _)| *other != item);
            nearer(others.map(|(_, distance)| distance).collect())
        };
        let rows = 0..self.clips.len();
        let of_all: usize = rows.map(|row| nearer(self.distances.to_later(row))).sum();
        Ranks {
            of_all: of_all + 1,
            from_a: others_nearer(a) + 1,
            from_b: others_nearer(b) + 1,
        }
    }
}

/// How many clusters a rule finds, and the criterion that says so.
pub(crate) fn clusters_of(
    rule: CutRule,
    distances: &Distances,
    tree: &Dendrogram,
) -> (usize, Vec<f64>) {
    match rule {
        CutRule::Number(clusters) => (clusters.clamp(1, tree.items.max(1)), Vec::new()),
        CutRule::Bic => {
            let values = bic::bic(distances.vectors().unwrap_or(&[]), tree);
            (bic::best(&values), values)
        }
        CutRule::Mojena => {
            let heights: Vec<f64> = tree.merges.iter().map(|merge| merge.height).collect();
            (mojena::mojena(&heights, mojena::DEVIATIONS), Vec::new())
        }
    }
}
