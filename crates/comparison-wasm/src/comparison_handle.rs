//! One set of clips: features go in clip by clip, its comparison is made step by step, and arrays and
//! short texts come out; what takes longer comes out of handles of its own.

use std::collections::HashSet;
use std::rc::Rc;

use comparison::comparison::{CannotCompare, Comparison};
use comparison::map::Place;
use comparison::run::ComparisonRun;
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::answers::{EvaluationHandle, ExplanationHandle};
use crate::clips::{self, NamedClip};
use crate::compared::Compared;
use crate::file_handle::FileHandle;
use crate::picture_handle::PictureHandle;
use crate::places::Places;
use crate::settings::{self, JsSettings};
use crate::{failure, texts};

/// One set in this memory. Free it once, with `free()`. All that speaks of clips and items speaks of
/// the latest comparison that is done; items count from 0 in the order of `clips()`. A handle that it
/// gives keeps the comparison of which it speaks.
#[wasm_bindgen]
#[derive(Default)]
pub struct ComparisonHandle {
    clips: Vec<NamedClip>,
    run: Option<Run>,
    compared: Option<Rc<Compared>>,
    places: Places,
    /// Memory for the distances of all pairs, from the last comparison that needed them.
    room: Vec<f64>,
}

/// A comparison that is being made.
struct Run {
    run: ComparisonRun,
    clips: Vec<NamedClip>,
    /// Whether clips stay where they lie.
    keeps_places: bool,
}

#[wasm_bindgen]
impl ComparisonHandle {
    /// A handle without clips.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Tells the feature of a clip, in place of the one told before: 12 numbers of the recorded body and
    /// of one of standard lengths, then 16 joints × 12 of both.
    #[wasm_bindgen(js_name = setFeature)]
    pub fn set_feature(
        &mut self,
        id: i32,
        name: String,
        recorded: &[f64],
        across_rigs: &[f64],
        recorded_by_joint: &[f64],
        across_rigs_by_joint: &[f64],
    ) -> Result<(), JsError> {
        let feature = clips::feature(
            recorded,
            across_rigs,
            recorded_by_joint,
            across_rigs_by_joint,
        );
        let clip = NamedClip {
            id,
            name,
            feature: Rc::new(feature.map_err(|message| failure::misuse(&message))?),
        };
        self.places.arrive(&clip);
        match self.clips.binary_search_by_key(&id, |one| one.id) {
            Ok(index) => self.clips[index] = clip,
            Err(index) => self.clips.insert(index, clip),
        }
        Ok(())
    }

    /// Takes the features of clips away.
    #[wasm_bindgen(js_name = removeFeatures)]
    pub fn remove_features(&mut self, ids: &[i32]) {
        let gone: HashSet<i32> = ids.iter().copied().collect();
        self.clips.retain(|clip| !gone.contains(&clip.id));
        for id in gone {
            self.places.leave(id);
        }
    }

    /// Tells where a clip lay on a map made by another handle: the next layout is turned onto it.
    #[wasm_bindgen(js_name = recallPlace)]
    pub fn recall_place(&mut self, id: i32, x: f64, y: f64) {
        self.places.recall(id, [x, y]);
    }

    /// How many clips can be compared.
    #[wasm_bindgen(js_name = clipCount)]
    pub fn clip_count(&self) -> u32 {
        self.clips.len() as u32
    }

    /// Makes ready to compare the clips told so far. With `keeps_places` the map's clips stay where they
    /// lie, unless they were laid out by another distance or would show too little. Throws the failure of settings that cannot be.
    pub fn begin(&mut self, settings: &JsSettings, keeps_places: bool) -> Result<(), JsError> {
        let settings = settings::settings(settings)?;
        // Its memory goes first: that of all pairs is much.
        self.run = None;
        let features = self.clips.iter().map(|clip| Rc::clone(&clip.feature));
        let room = std::mem::take(&mut self.room);
        let run = ComparisonRun::in_room(features.collect(), settings, room);
        self.run = Some(Run {
            run: run.map_err(|error| cannot_compare(&error))?,
            clips: self.clips.clone(),
            keeps_places: keeps_places && self.places.fit(settings.distance),
        });
        Ok(())
    }

    /// A few milliseconds of work. Returns the part done; 1 when the comparison is there.
    pub fn step(&mut self) -> Result<f64, JsError> {
        let Some(run) = &mut self.run else {
            return Err(failure::misuse("step: begin must come first"));
        };
        let done = run.run.step();
        if done >= 1.0
            && let Some(run) = self.run.take()
        {
            self.take(run);
        }
        Ok(done)
    }

    /// The clip of each item.
    #[wasm_bindgen(js_name = clips)]
    pub fn clip_ids(&self) -> Result<Vec<i32>, JsError> {
        Ok(self.compared()?.clips.iter().map(|clip| clip.id).collect())
    }

    /// The left cluster of each merge, in SciPy's labelling.
    pub fn left(&self) -> Result<Vec<i32>, JsError> {
        let merges = self.comparison()?.tree.merges.iter();
        Ok(merges.map(|merge| merge.left as i32).collect())
    }

    /// The right cluster of each merge.
    pub fn right(&self) -> Result<Vec<i32>, JsError> {
        let merges = self.comparison()?.tree.merges.iter();
        Ok(merges.map(|merge| merge.right as i32).collect())
    }

    /// The height of each merge.
    pub fn heights(&self) -> Result<Vec<f64>, JsError> {
        let merges = self.comparison()?.tree.merges.iter();
        Ok(merges.map(|merge| merge.height).collect())
    }

    /// The items below each merge.
    pub fn sizes(&self) -> Result<Vec<i32>, JsError> {
        let merges = self.comparison()?.tree.merges.iter();
        Ok(merges.map(|merge| merge.size as i32).collect())
    }

    /// Items from left to right.
    pub fn leaves(&self) -> Result<Vec<i32>, JsError> {
        let leaves = self.comparison()?.order.leaves.iter();
        Ok(leaves.map(|item| *item as i32).collect())
    }

    /// Whether no order that the tree allows has nearer neighbours.
    #[wasm_bindgen(js_name = orderIsOptimal)]
    pub fn order_is_optimal(&self) -> Result<bool, JsError> {
        Ok(self.comparison()?.order.optimal)
    }

    /// The item nearest to each; −1 without another.
    pub fn nearest(&self) -> Result<Vec<i32>, JsError> {
        let nearest = self.comparison()?.spread.nearest.iter();
        Ok(nearest
            .map(|item| item.map_or(-1, |item| item as i32))
            .collect())
    }

    /// How far it is.
    #[wasm_bindgen(js_name = nearestDistances)]
    pub fn nearest_distances(&self) -> Result<Vec<f64>, JsError> {
        Ok(self.comparison()?.spread.nearest_distances.clone())
    }

    /// Where the items lie: items × 2.
    pub fn map(&self) -> Result<Vec<f64>, JsError> {
        Ok(self
            .comparison()?
            .map
            .places
            .iter()
            .flatten()
            .copied()
            .collect())
    }

    /// Clips that have come since the comparison.
    pub fn arrivals(&self) -> Vec<i32> {
        self.arrived().map(|(id, _)| id).collect()
    }

    /// Where they lie on its map: clips × 2.
    #[wasm_bindgen(js_name = arrivalPlaces)]
    pub fn arrival_places(&self) -> Vec<f64> {
        self.arrived().flat_map(|(_, place)| place).collect()
    }

    /// Pairs, clusters by the linkage's rule, the legend's end, the largest distance, and the part of
    /// the spread that the map shows.
    pub fn numbers(&self) -> Result<Vec<f64>, JsError> {
        let comparison = self.comparison()?;
        Ok(vec![
            comparison.distances.pairs() as f64,
            comparison.automatic_clusters as f64,
            comparison.spread.legend_maximum,
            comparison.spread.maximum,
            comparison.map.spread,
        ])
    }

    /// The cluster of each item at a cut, from 0 in the order of the tree.
    pub fn cut(&self, clusters: u32) -> Result<Vec<i32>, JsError> {
        let cut = self.comparison()?.cut(clusters as usize);
        Ok(cut
            .cluster_of_item
            .iter()
            .map(|cluster| *cluster as i32)
            .collect())
    }

    /// The height of that cut.
    #[wasm_bindgen(js_name = cutHeight)]
    pub fn cut_height(&self, clusters: u32) -> Result<f64, JsError> {
        Ok(self.comparison()?.tree.cut_height(clusters as usize))
    }

    /// The cells of these items, from top to bottom and from left to right, as at most `most` × `most`
    /// pixels.
    pub fn picture(
        &self,
        rows: &[i32],
        columns: &[i32],
        most: u32,
    ) -> Result<PictureHandle, JsError> {
        PictureHandle::new(self.compared()?, rows, columns, most)
    }

    /// Why two clips differ.
    pub fn explain(&self, a: i32, b: i32) -> Result<ExplanationHandle, JsError> {
        ExplanationHandle::new(self.compared()?, a, b)
    }

    /// The clips nearest to one, as JSON.
    pub fn neighbours(&self, clip: i32, most: u32) -> Result<String, JsError> {
        let compared = self.compared()?;
        let found = compared
            .comparison
            .neighbours(compared.item_of(clip)?, most as usize);
        Ok(texts::neighbours(&found, |item| compared.clips[item].id).text())
    }

    /// How well the distance and a cut tell labels apart. `labels`: the label of each item, from 0;
    /// below 0: none.
    pub fn evaluate(&self, labels: &[i32], clusters: u32) -> Result<EvaluationHandle, JsError> {
        EvaluationHandle::new(self.compared()?, labels, clusters)
    }

    /// A file: `kind` is `features-csv`, `features-npy`, `matrix-csv`, `matrix-npy`, `tree-newick`,
    /// `evaluation-csv` or `evaluation-json`. `names` are the labels that `labels`, one for each item and
    /// below 0 where there is none, speaks of.
    pub fn file(
        &self,
        kind: &str,
        names: Vec<String>,
        labels: &[i32],
        clusters: u32,
    ) -> Result<FileHandle, JsError> {
        FileHandle::new(self.compared()?, kind, names, labels, clusters)
    }
}

impl ComparisonHandle {
    /// Keeps a comparison, its map as the one before lay.
    fn take(&mut self, run: Run) {
        let clips = run.clips;
        let (mut comparison, room) = run.run.finish_with_room();
        self.room = room;
        let kept = match run.keeps_places {
            true => self.places.keep(comparison.map.clone(), &clips),
            false => None,
        };
        comparison.map =
            kept.unwrap_or_else(|| self.places.lay_out(&comparison, &clips, &self.clips));
        self.compared = Some(Rc::new(Compared { comparison, clips }));
    }

    /// The clips told that the comparison made last does not cover, with their places.
    fn arrived(&self) -> impl Iterator<Item = (i32, Place)> {
        let covers = |clip: &NamedClip| {
            let compared = self.compared.as_ref();
            compared.is_some_and(|compared| compared.item(clip.id).is_some())
        };
        let arrived = self.clips.iter().filter(move |clip| !covers(clip));
        arrived.filter_map(|clip| Some((clip.id, self.places.of(clip)?)))
    }

    fn compared(&self) -> Result<&Rc<Compared>, JsError> {
        let compared = self.compared.as_ref();
        compared.ok_or_else(|| failure::misuse("there is no comparison yet"))
    }

    fn comparison(&self) -> Result<&Comparison, JsError> {
        Ok(&self.compared()?.comparison)
    }
}

fn cannot_compare(error: &CannotCompare) -> JsError {
    match error {
        CannotCompare::Settings(error) => failure::misuse(&error.to_string()),
        CannotCompare::Memory(pairs) => failure::too_many_pairs(pairs),
    }
}
