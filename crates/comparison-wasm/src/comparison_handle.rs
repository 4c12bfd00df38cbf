//! One set of clips: features go in clip by clip, its comparison is made step by step, and arrays and
//! short texts come out.

use std::rc::Rc;

use comparison::comparison::{Comparison, Evaluation};
use comparison::evaluation::{self, OneNearest};
use comparison::map::Place;
use comparison::picture::{Picture, PictureRun, Region};
use comparison::report::{Labels, Subject};
use comparison::run::ComparisonRun;
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::clips::{self, NamedClip};
use crate::places::Places;
use crate::settings::{self, JsSettings};
use crate::{exports, failure, texts};

/// Cells of a picture that are looked at in one step.
const CELLS_A_STEP: usize = 1 << 19;

/// One set in this memory. Free it once, with `free()`. All that speaks of clips and items speaks of
/// the latest comparison that is done; items count from 0 in the order of `clips()`.
#[wasm_bindgen]
#[derive(Default)]
pub struct ComparisonHandle {
    clips: Vec<NamedClip>,
    run: Option<Run>,
    compared: Option<Compared>,
    places: Places,
    picturing: Option<PictureRun>,
    picture: Picture,
    /// The labels last evaluated, and what came of it: a cut that is drawn along asks again and again.
    one_nearest: Option<(Vec<Option<usize>>, OneNearest)>,
}

/// A comparison that is being made.
struct Run {
    run: ComparisonRun,
    clips: Vec<NamedClip>,
    /// Whether clips stay where they lie.
    keeps_places: bool,
}

/// A comparison and the clips that its items are.
struct Compared {
    comparison: Comparison,
    clips: Vec<NamedClip>,
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

    /// Takes the feature of a clip away.
    #[wasm_bindgen(js_name = removeFeature)]
    pub fn remove_feature(&mut self, id: i32) {
        self.clips.retain(|clip| clip.id != id);
        self.places.leave(id);
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
    /// lie, unless they were laid out by another distance. Throws the failure of settings that cannot be.
    pub fn begin(&mut self, settings: &JsSettings, keeps_places: bool) -> Result<(), JsError> {
        let settings = settings::settings(settings)?;
        let features = self.clips.iter().map(|clip| Rc::clone(&clip.feature));
        let run = ComparisonRun::new(features.collect(), settings);
        self.run = Some(Run {
            run: run.map_err(|error| failure::misuse(&error.to_string()))?,
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

    /// Makes ready to picture the cells of these items, from top to bottom and from left to right, as at
    /// most `most` × `most` pixels.
    #[wasm_bindgen(js_name = beginPicture)]
    pub fn begin_picture(
        &mut self,
        rows: &[i32],
        columns: &[i32],
        most: u32,
    ) -> Result<(), JsError> {
        let comparison = self.comparison()?;
        let items = comparison.clips.len();
        let region = Region {
            rows: items_of(rows, items)?,
            columns: items_of(columns, items)?,
            most: most as usize,
        };
        self.picturing = Some(PictureRun::new(&comparison.distances, region));
        Ok(())
    }

    /// A few milliseconds of work on the picture. Returns the part done; 1 when it is there.
    #[wasm_bindgen(js_name = stepPicture)]
    pub fn step_picture(&mut self) -> Result<f64, JsError> {
        let Some(mut run) = self.picturing.take() else {
            return Err(failure::misuse("stepPicture: beginPicture must come first"));
        };
        let done = run.step(&self.comparison()?.distances, CELLS_A_STEP);
        match done < 1.0 {
            true => self.picturing = Some(run),
            false => self.picture = run.finish(),
        }
        Ok(done)
    }

    /// Rows of the picture.
    #[wasm_bindgen(js_name = pictureRows)]
    pub fn picture_rows(&self) -> u32 {
        self.picture.rows as u32
    }

    /// Columns of the picture.
    #[wasm_bindgen(js_name = pictureColumns)]
    pub fn picture_columns(&self) -> u32 {
        self.picture.columns as u32
    }

    /// Hands the picture over: mean distances, row by row.
    #[wasm_bindgen(js_name = takePicture)]
    pub fn take_picture(&mut self) -> Vec<f32> {
        std::mem::take(&mut self.picture).values
    }

    /// Why two clips differ, as JSON.
    pub fn explain(&self, a: i32, b: i32) -> Result<String, JsError> {
        let compared = self.compared()?;
        let (a, b) = (compared.item(a)?, compared.item(b)?);
        let comparison = &compared.comparison;
        let found = comparison.explain(a, b);
        Ok(texts::explanation(&found, comparison.ranks(a, b)).text())
    }

    /// The clips nearest to one, as JSON.
    pub fn neighbours(&self, clip: i32, most: u32) -> Result<String, JsError> {
        let compared = self.compared()?;
        let found = compared
            .comparison
            .neighbours(compared.item(clip)?, most as usize);
        Ok(texts::neighbours(&found, |item| compared.clips[item].id).text())
    }

    /// How well the distance and a cut tell labels apart, as JSON. `labels`: the label of each item,
    /// from 0; below 0: none.
    pub fn evaluate(&mut self, labels: &[i32], clusters: u32) -> Result<String, JsError> {
        let labels = labels_of(labels, self.comparison()?.clips.len())?;
        let one_nearest = match self.one_nearest.take() {
            Some((last, found)) if last == labels => found,
            _ => self.comparison()?.one_nearest(&labels),
        };
        let compared = self.compared()?;
        let cut = compared.comparison.cut(clusters as usize);
        let scores = evaluation::clustering(&cut.cluster_of_item, &labels);
        let found = Evaluation {
            one_nearest,
            scores,
        };
        let text = texts::evaluation(&found, |item| compared.clips[item].id).text();
        self.one_nearest = Some((labels, found.one_nearest));
        Ok(text)
    }

    /// The bytes of a file: `kind` is `features-csv`, `features-npy`, `matrix-csv`, `matrix-npy`,
    /// `tree-newick`, `evaluation-csv` or `evaluation-json`. `names` are the labels that `labels`, one
    /// for each item and below 0 where there is none, speaks of.
    #[wasm_bindgen(js_name = exportFile)]
    pub fn export_file(
        &self,
        kind: &str,
        names: Vec<String>,
        labels: &[i32],
        clusters: u32,
    ) -> Result<Vec<u8>, JsError> {
        let Compared { comparison, clips } = self.compared()?;
        let labels = Labels {
            names,
            of_item: labels_of(labels, clips.len())?,
        };
        let names: Vec<String> = clips.iter().map(|clip| clip.name.clone()).collect();
        let subject = Subject {
            names: &names,
            comparison,
            cut: &comparison.cut(clusters as usize),
            labels: Some(&labels),
        };
        let bytes = exports::bytes(kind, &subject);
        bytes.ok_or_else(|| failure::misuse(&format!("exportFile: unknown kind {kind}")))
    }
}

impl ComparisonHandle {
    /// Keeps a comparison, its map as the one before lay.
    fn take(&mut self, run: Run) {
        let clips = run.clips;
        let mut comparison = run.run.finish();
        let distance = comparison.settings.distance;
        let (places, map) = (&mut self.places, comparison.map);
        comparison.map = match run.keeps_places {
            true => places.keep(map, &clips),
            false => places.lay_out(distance, map, &clips, &self.clips),
        };
        self.one_nearest = None;
        self.picturing = None;
        self.compared = Some(Compared { comparison, clips });
    }

    /// The clips told that the comparison made last does not cover, with their places.
    fn arrived(&self) -> impl Iterator<Item = (i32, Place)> {
        let covers = |clip: &NamedClip| {
            let compared = self.compared.as_ref();
            compared.is_some_and(|compared| compared.item(clip.id).is_ok())
        };
        let arrived = self.clips.iter().filter(move |clip| !covers(clip));
        arrived.filter_map(|clip| Some((clip.id, self.places.of(clip)?)))
    }

    fn compared(&self) -> Result<&Compared, JsError> {
        let compared = self.compared.as_ref();
        compared.ok_or_else(|| failure::misuse("there is no comparison yet"))
    }

    fn comparison(&self) -> Result<&Comparison, JsError> {
        Ok(&self.compared()?.comparison)
    }
}

impl Compared {
    fn item(&self, clip: i32) -> Result<usize, JsError> {
        let item = self.clips.binary_search_by_key(&clip, |one| one.id);
        item.map_err(|_| failure::misuse(&format!("clip {clip} is not in the comparison")))
    }
}

/// Items by their numbers.
fn items_of(numbers: &[i32], items: usize) -> Result<Vec<usize>, JsError> {
    let item = |number: &i32| usize::try_from(*number).ok().filter(|item| *item < items);
    let found: Option<Vec<usize>> = numbers.iter().map(item).collect();
    found.ok_or_else(|| failure::misuse("an item that is not in the comparison"))
}

/// Labels by their numbers, one for each item.
fn labels_of(numbers: &[i32], items: usize) -> Result<Vec<Option<usize>>, JsError> {
    if numbers.len() != items {
        return Err(failure::misuse("as many labels as items are needed"));
    }
    Ok(numbers
        .iter()
        .map(|number| usize::try_from(*number).ok())
        .collect())
}
