//! The comparison while it is made: clips' features and settings go in, a [`Comparison`] comes out, a
//! few milliseconds at a step: distances, tree, order, spread, map.

use std::rc::Rc;

use crate::comparison::{Comparison, clusters_of};
use crate::condensed::Condensed;
use crate::dendrogram::Dendrogram;
use crate::distances::Distances;
use crate::feature::ClipFeature;
use crate::leaf_order::{self, Order};
use crate::linkage::{GroupAverageSteps, WardSteps};
use crate::map::{self, Map};
use crate::settings::{Linkage, Settings, SettingsError};
use crate::spread::{Spread, SpreadRun};

/// Pairs looked at in one step.
const PAIRS_A_STEP: usize = 1 << 18;

/// Parts of the whole that are done when a piece is.
const FILLED: f64 = 0.2;
const LINKED: f64 = 0.7;
const ORDERED: f64 = 0.8;
const SPREAD: f64 = 0.95;

/// The pieces, in the order in which they are made.
pub struct ComparisonRun {
    settings: Settings,
    clips: Vec<Rc<ClipFeature>>,
    /// The distances of pairs so far.
    filled: Vec<f64>,
    row: usize,
    distances: Option<Distances>,
    linking: Option<Linking>,
    tree: Option<Dendrogram>,
    order: Option<Order>,
    spread_run: Option<SpreadRun>,
    spread: Option<Spread>,
    map: Option<Map>,
}

enum Linking {
    Ward(WardSteps),
    Average(GroupAverageSteps),
}

impl ComparisonRun {
    /// Nothing compared yet.
    ///
    /// # Errors
    /// Settings that do not go together.
    pub fn new(clips: Vec<Rc<ClipFeature>>, settings: Settings) -> Result<Self, SettingsError> {
        settings.validate()?;
        Ok(Self {
            distances: settings.distance.vectors(&clips).map(Distances::of_vectors),
            settings,
            clips,
            filled: Vec::new(),
            row: 0,
            linking: None,
            tree: None,
            order: None,
            spread_run: None,
            spread: None,
            map: None,
        })
    }

    /// Makes a part of the first missing piece. Returns the part done, 1 when all are there.
    pub fn step(&mut self) -> f64 {
        if self.tree.is_none() {
            return self.step_tree();
        }
        let (Some(distances), Some(tree)) = (&self.distances, &self.tree) else {
            return 1.0;
        };
        if self.order.is_none() {
            self.order = Some(leaf_order::optimal(tree, &|a, b| distances.at(a, b)));
            return ORDERED;
        }
        if self.spread.is_none() {
            return self.step_spread();
        }
        if self.map.is_none() {
            self.map = Some(map_of(distances));
        }
        1.0
    }

    /// Does what is left.
    pub fn finish(mut self) -> Comparison {
        while self.step() < 1.0 {}
        let items = self.clips.len();
        let distances = self.distances.unwrap_or(Distances::of_vectors(Vec::new()));
        let tree = self.tree.unwrap_or(Dendrogram {
            items,
            merges: Vec::new(),
        });
        let (automatic_clusters, bic) = clusters_of(self.settings.rule(), &distances, &tree);
        Comparison {
            settings: self.settings,
            clips: self.clips,
            order: self.order.unwrap_or(Order {
                leaves: (0..items).collect(),
                optimal: true,
            }),
            spread: self.spread.unwrap_or_default(),
            map: self.map.unwrap_or_else(|| map_of(&distances)),
            distances,
            tree,
            automatic_clusters,
            bic,
        }
    }

    fn step_spread(&mut self) -> f64 {
        let Some(distances) = &self.distances else {
            return SPREAD;
        };
        let mut run = match self.spread_run.take() {
            Some(run) => run,
            None => SpreadRun::new(distances),
        };
        let done = run.step(distances, PAIRS_A_STEP);
        match done < 1.0 {
            true => self.spread_run = Some(run),
            false => self.spread = Some(run.finish()),
        }
        ORDERED + (SPREAD - ORDERED) * done
    }

    /// Fills the distances of pairs where the tree needs them, then joins clusters.
    fn step_tree(&mut self) -> f64 {
        let Some(linking) = &mut self.linking else {
            return self.step_towards_linking();
        };
        let done = match linking {
            Linking::Ward(steps) => steps.step(PAIRS_A_STEP),
            Linking::Average(steps) => steps.step(PAIRS_A_STEP),
        };
        if done >= 1.0 {
            self.tree = self.linking.take().map(Linking::finish);
        }
        FILLED + (LINKED - FILLED) * done
    }

    fn step_towards_linking(&mut self) -> f64 {
        if let (Linkage::Ward, Some(distances)) = (self.settings.linkage, &self.distances) {
            let vectors = distances.vectors().unwrap_or(&[]);
            self.linking = Some(Linking::Ward(WardSteps::new(vectors)));
            return FILLED;
        }
        let items = self.clips.len();
        let until = self.filled.len() + PAIRS_A_STEP;
        while self.row < items && self.filled.len() < until {
            self.fill_row();
        }
        if self.row == items {
            let values = core::mem::take(&mut self.filled);
            let matrix = Condensed { items, values };
            self.linking = Some(Linking::Average(GroupAverageSteps::new(&matrix)));
            self.distances.get_or_insert(Distances::Stored(matrix));
        }
        FILLED * self.row as f64 / items.max(1) as f64
    }

    fn fill_row(&mut self) {
        match &self.distances {
            Some(distances) => self.filled.extend(distances.to_later(self.row)),
            None => {
                let (from, later) = (&self.clips[self.row], &self.clips[self.row + 1..]);
                let distance = self.settings.distance;
                let values = later.iter().map(|to| distance.between(from, to).value);
                self.filled.extend(values);
            }
        }
        self.row += 1;
    }
}

impl Linking {
    fn finish(self) -> Dendrogram {
        match self {
            Linking::Ward(steps) => steps.finish(),
            Linking::Average(steps) => steps.finish(),
        }
    }
}

fn map_of(distances: &Distances) -> Map {
    match distances {
        Distances::OfVectors(_) => map::of_vectors(distances.vectors().unwrap_or(&[])),
        Distances::Stored(matrix) => map::of_matrix(matrix),
    }
}
