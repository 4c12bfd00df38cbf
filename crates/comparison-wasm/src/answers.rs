//! Answers that need a look at many pairs: clips or labels go in, the answer is made step by step, and
//! comes out as JSON.

use std::rc::Rc;

use comparison::comparison::Evaluation;
use comparison::evaluation::{self, OneNearestRun};
use comparison::ranks::RanksRun;
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::compared::Compared;
use crate::{failure, texts};

/// Pairs looked at in one step.
const PAIRS_A_STEP: usize = 1 << 18;

/// Why two clips differ. Free it once, with `free()`.
#[wasm_bindgen]
pub struct ExplanationHandle {
    compared: Rc<Compared>,
    a: usize,
    b: usize,
    ranks: RanksRun,
}

impl ExplanationHandle {
    pub(crate) fn new(compared: &Rc<Compared>, a: i32, b: i32) -> Result<Self, JsError> {
        let (a, b) = (compared.item_of(a)?, compared.item_of(b)?);
        Ok(Self {
            ranks: RanksRun::new(&compared.comparison.distances, a, b),
            compared: Rc::clone(compared),
            a,
            b,
        })
    }
}

#[wasm_bindgen]
impl ExplanationHandle {
    /// A few milliseconds of work. Returns the part done; 1 when the answer is there.
    pub fn step(&mut self) -> f64 {
        let distances = &self.compared.comparison.distances;
        self.ranks.step(distances, PAIRS_A_STEP)
    }

    /// The answer, once `step` has said 1.
    pub fn text(&self) -> String {
        let found = self.compared.comparison.explain(self.a, self.b);
        texts::explanation(&found, self.ranks.clone().finish()).text()
    }
}

/// How well the distance and a cut tell labels apart. Free it once, with `free()`.
#[wasm_bindgen]
pub struct EvaluationHandle {
    compared: Rc<Compared>,
    labels: Vec<Option<usize>>,
    clusters: usize,
    run: Option<OneNearestRun>,
}

impl EvaluationHandle {
    pub(crate) fn new(
        compared: &Rc<Compared>,
        labels: &[i32],
        clusters: u32,
    ) -> Result<Self, JsError> {
        let labels = compared.labels(labels)?;
        Ok(Self {
            compared: Rc::clone(compared),
            run: Some(OneNearestRun::new(labels.clone())),
            labels,
            clusters: clusters as usize,
        })
    }
}

#[wasm_bindgen]
impl EvaluationHandle {
    /// A few milliseconds of work. Returns the part done; 1 when the answer is there.
    pub fn step(&mut self) -> f64 {
        let comparison = &self.compared.comparison;
        let (distances, spread) = (&comparison.distances, &comparison.spread);
        let run = self.run.as_mut();
        run.map_or(1.0, |run| run.step(distances, spread, PAIRS_A_STEP))
    }

    /// Hands the answer over, once `step` has said 1.
    #[wasm_bindgen(js_name = takeText)]
    pub fn take_text(&mut self) -> Result<String, JsError> {
        let run = self.run.take();
        let run = run.ok_or_else(|| failure::misuse("takeText: it has been taken"))?;
        let Compared { comparison, clips } = &*self.compared;
        let cut = comparison.cut(self.clusters);
        let found = Evaluation {
            one_nearest: run.finish(),
            scores: evaluation::clustering(&cut.cluster_of_item, &self.labels),
        };
        Ok(texts::evaluation(&found, |item| clips[item].id).text())
    }
}
