//! The comparison while it is made: clips' features and settings go in, a [`Comparison`] comes out, a
//! few milliseconds at a step: distances, tree, order, spread, map.
//!
//! Group average needs the distances of all pairs in memory, eight bytes a pair. They are given up to
//! the tree once nothing else needs them; all that is asked later computes its distances anew.

use std::rc::Rc;

use crate::comparison::{CannotCompare, Comparison};
use crate::condensed::Condensed;
use crate::cut;
use crate::dendrogram::Dendrogram;
use crate::distances::Distances;
use crate::feature::ClipFeature;
use crate::leaf_order::{Order, OrderSteps};
use crate::linkage::{GroupAverageSteps, WardSteps};
use crate::map::{self, Map, MatrixMapSteps};
use crate::settings::{Linkage, Settings};
use crate::spread::{Spread, SpreadRun};

/// Pairs looked at in one step.
const PAIRS_A_STEP: usize = 1 << 18;

/// The pieces, in the order in which they are made.
pub struct ComparisonRun {
    settings: Settings,
    clips: Vec<Rc<ClipFeature>>,
    distances: Distances,
    work: Work,
    /// Weights of the pieces that are done.
    done: f64,
    /// The map, where it is made from all pairs; else it is made at the end.
    map: Option<Map>,
    tree: Dendrogram,
    order: Order,
    spread: Spread,
    clusters: usize,
    bic: Vec<f64>,
    /// The memory of the matrix, when it is not needed any more.
    room: Vec<f64>,
}

/// What is under way.
enum Work {
    /// The distances of all pairs so far, and the next row.
    Filling(Condensed, usize),
    Mapping(Condensed, MatrixMapSteps),
    Ward(WardSteps),
    Average(GroupAverageSteps),
    Ordering(OrderSteps),
    Spreading(SpreadRun),
    Cutting,
    Done,
}

/// How long the pieces take, about, beside each other.
mod weight {
    pub const FILLING: f64 = 1.0;
    pub const MAPPING: f64 = 8.0;
    pub const WARD: f64 = 1.0;
    pub const AVERAGE: f64 = 6.0;
    pub const ORDERING: f64 = 2.0;
    pub const SPREADING: f64 = 2.0;
    pub const CUTTING: f64 = 0.05;
}

impl ComparisonRun {
    /// Nothing compared yet.
    ///
    /// # Errors
    /// Settings that do not go together; not enough memory for all pairs.
    pub fn new(clips: Vec<Rc<ClipFeature>>, settings: Settings) -> Result<Self, CannotCompare> {
        Self::in_room(clips, settings, Vec::new())
    }

    /// The same, in the memory that [`Self::finish_with_room`] gave, if it suffices: where memory once
    /// taken is never given back, a hole that is a little too small costs as much again.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn in_room(
        clips: Vec<Rc<ClipFeature>>,
        settings: Settings,
        room: Vec<f64>,
    ) -> Result<Self, CannotCompare> {
        settings.validate()?;
        let distances = Distances::of(settings.distance, &clips);
        let items = clips.len();
        let (work, room) = match settings.linkage {
            Linkage::Ward => {
                let vectors = distances.vectors().unwrap_or(&[]);
                (Work::Ward(WardSteps::new(vectors)), room)
            }
            Linkage::Average => {
                let matrix = Condensed::with_room(items, room)?;
                (Work::Filling(matrix, 0), Vec::new())
            }
        };
        Ok(Self {
            settings,
            clips,
            distances,
            work,
            done: 0.0,
            map: None,
            tree: Dendrogram {
                items,
                merges: Vec::new(),
            },
            order: Order {
                leaves: Vec::new(),
                optimal: true,
            },
            spread: Spread::default(),
            clusters: 0,
            bic: Vec::new(),
            room,
        })
    }

    /// Makes a part of the first missing piece. Returns the part done, 1 when all are there.
    pub fn step(&mut self) -> f64 {
        let (part, weight) = match &mut self.work {
            Work::Filling(matrix, row) => (fill(matrix, row, &self.distances), weight::FILLING),
            Work::Mapping(matrix, steps) => (steps.step(matrix, PAIRS_A_STEP), weight::MAPPING),
            Work::Ward(steps) => (steps.step(PAIRS_A_STEP), weight::WARD),
            Work::Average(steps) => (steps.step(PAIRS_A_STEP), weight::AVERAGE),
            Work::Ordering(steps) => {
                let distance = |a: usize, b: usize| self.distances.at(a, b);
                (steps.step(PAIRS_A_STEP, &distance), weight::ORDERING)
            }
            Work::Spreading(run) => (run.step(&self.distances, PAIRS_A_STEP), weight::SPREADING),
            Work::Cutting => (1.0, weight::CUTTING),
            Work::Done => return 1.0,
        };
        if part < 1.0 {
            return (self.done + weight * part) / self.weight_of_all();
        }
        self.done += weight;
        self.begin_next();
        match self.work {
            Work::Done => 1.0,
            _ => self.done / self.weight_of_all(),
        }
    }

    /// Does what is left.
    pub fn finish(self) -> Comparison {
        self.finish_with_room().0
    }

    /// The same, with memory for another run.
    pub fn finish_with_room(mut self) -> (Comparison, Vec<f64>) {
        while self.step() < 1.0 {}
        let vectors = self.distances.vectors().unwrap_or(&[]);
        let comparison = Comparison {
            settings: self.settings,
            clips: self.clips,
            map: self.map.unwrap_or_else(|| map::of_vectors(vectors)),
            distances: self.distances,
            tree: self.tree,
            order: self.order,
            spread: self.spread,
            automatic_clusters: self.clusters,
            bic: self.bic,
        };
        (comparison, self.room)
    }

    /// Keeps the piece that is done and begins the one that follows it.
    fn begin_next(&mut self) {
        self.work = match std::mem::replace(&mut self.work, Work::Done) {
            Work::Filling(matrix, _) if self.distances.vectors().is_none() => {
                let steps = MatrixMapSteps::new(&matrix);
                Work::Mapping(matrix, steps)
            }
            Work::Filling(matrix, _) => Work::Average(GroupAverageSteps::in_place(matrix)),
            Work::Mapping(matrix, steps) => {
                self.map = Some(steps.finish(&matrix));
                Work::Average(GroupAverageSteps::in_place(matrix))
            }
            Work::Ward(steps) => self.keep_tree(steps.finish()),
            Work::Average(steps) => {
                let (tree, room) = steps.finish_with_room();
                self.room = room;
                self.keep_tree(tree)
            }
            Work::Ordering(steps) => {
                self.order = steps.finish(&|a, b| self.distances.at(a, b));
                Work::Spreading(SpreadRun::new(&self.distances))
            }
            Work::Spreading(run) => {
                self.spread = run.finish();
                Work::Cutting
            }
            Work::Cutting => {
                let vectors = self.distances.vectors().unwrap_or(&[]);
                let rule = self.settings.rule();
                (self.clusters, self.bic) = cut::clusters(rule, vectors, &self.tree);
                Work::Done
            }
            Work::Done => Work::Done,
        };
    }

    fn keep_tree(&mut self, tree: Dendrogram) -> Work {
        self.tree = tree;
        Work::Ordering(OrderSteps::new(&self.tree))
    }

    fn weight_of_all(&self) -> f64 {
        let needs_matrix = self.distances.vectors().is_none();
        let mapping = if needs_matrix { weight::MAPPING } else { 0.0 };
        let tree = match self.settings.linkage {
            Linkage::Ward => weight::WARD,
            Linkage::Average => weight::FILLING + weight::AVERAGE,
        };
        tree + mapping + weight::ORDERING + weight::SPREADING + weight::CUTTING
    }
}

impl Comparison {
    /// Compares clips at once; in pieces: [`ComparisonRun`].
    ///
    /// # Errors
    /// Settings that do not go together; not enough memory for all pairs.
    pub fn of(clips: Vec<Rc<ClipFeature>>, settings: Settings) -> Result<Self, CannotCompare> {
        Ok(ComparisonRun::new(clips, settings)?.finish())
    }
}

/// Adds rows to a matrix, from `row` on. Returns the part that is filled.
fn fill(matrix: &mut Condensed, row: &mut usize, distances: &Distances) -> f64 {
    let until = matrix.values.len() + PAIRS_A_STEP;
    while *row < matrix.items && matrix.values.len() < until {
        matrix.values.extend(distances.to_later(*row));
        *row += 1;
    }
    distances.part_of_rows(*row)
}
