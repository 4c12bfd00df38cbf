//! One set of clips: features go in clip by clip, its comparison is made step by step, and arrays and
//! short texts come out.

use std::collections::HashMap;
use std::rc::Rc;

use comparison::comparison::{Comparison, Evaluation};
use comparison::evaluation::{self, OneNearest};
use comparison::map::{self, Place};
use comparison::picture::{Picture, PictureRun, Region};
use comparison::report::{Labels, Subject};
use comparison::run::ComparisonRun;
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::clips::{self, NamedClip};
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
    run: Option<(ComparisonRun, Vec<NamedClip>)>,
    compared: Option<Compared>,
    /// Where clips lay on the latest map.
    places: HashMap<i32, Place>,
    picturing: Option<PictureRun>,
    picture: Picture,
    /// The labels last evaluated, and what came of it: a cut that is drawn along asks again and again.
    one_nearest: Option<(Vec<Option<usize>>, OneNearest)>,
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
        match self.clips.iter_mut().find(|one| one.id == id) {
            Some(place) => *place = clip,
            None => self.clips.push(clip),
        }
        Ok(())
    }

    /// Takes the feature of a clip away.
    #[wasm_bindgen(js_name = removeFeature)]
    pub fn remove_feature(&mut self, id: i32) {
        self.clips.retain(|clip| clip.id != id);
    }

    /// How many clips can be compared.
    #[wasm_bindgen(js_name = clipCount)]
    pub fn clip_count(&self) -> u32 {
        self.clips.len() as u32
    }

    /// Makes ready to compare the clips told so far. Throws the failure of settings that cannot be.
    pub fn begin(&mut self, settings: &JsSettings) -> Result<(), JsError> {
        let settings = settings::settings(settings)?;
        let features = self.clips.iter().map(|clip| Rc::clone(&clip.feature));
        let run = ComparisonRun::new(features.collect(), settings);
        let run = run.map_err(|error| failure::misuse(&error.to_string()))?;
        self.run = Some((run, self.clips.clone()));
        Ok(())
    }

    /// A few milliseconds of work. Returns the part done; 1 when the comparison is there.
    pub fn step(&mut self) -> Result<f64, JsError> {
        let Some((run, _)) = &mut self.run else {
            return Err(failure::misuse("step: begin must come first"));
        };
        let done = run.step();
        if done >= 1.0
            && let Some((run, clips)) = self.run.take()
        {
            self.take(run.finish(), clips);
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
    fn take(&mut self, mut comparison: Comparison, clips: Vec<NamedClip>) {
        let items = clips.iter().enumerate();
        let place = |(item, clip): (usize, &NamedClip)| Some((item, *self.places.get(&clip.id)?));
        let known: Vec<(usize, Place)> = items.filter_map(place).collect();
        comparison.map = map::procrustes(&comparison.map, &known);
        let places = clips.iter().zip(&comparison.map.places);
        self.places = places.map(|(clip, place)| (clip.id, *place)).collect();
        self.one_nearest = None;
        self.picturing = None;
        self.compared = Some(Compared { comparison, clips });
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
        let item = self.clips.iter().position(|one| one.id == clip);
        item.ok_or_else(|| failure::misuse(&format!("clip {clip} is not in the comparison")))
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
