//! A file for other programs on its way: its kind and labels go in, its bytes come out part by part.

use std::rc::Rc;

use comparison::comparison::Cut;
use comparison::report::{FileKind, FileRun, Labels, Subject};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::compared::Compared;
use crate::failure;

/// Numbers written in one step.
const NUMBERS_A_STEP: usize = 1 << 13;

/// One file in this memory. Free it once, with `free()`.
#[wasm_bindgen]
pub struct FileHandle {
    compared: Rc<Compared>,
    names: Vec<String>,
    cut: Cut,
    labels: Labels,
    run: FileRun,
}

impl FileHandle {
    pub(crate) fn new(
        compared: &Rc<Compared>,
        kind: &str,
        label_names: Vec<String>,
        labels: &[i32],
        clusters: u32,
    ) -> Result<Self, JsError> {
        let kind = FileKind::named(kind)
            .ok_or_else(|| failure::misuse(&format!("file: unknown kind {kind}")))?;
        let labels = Labels {
            names: label_names,
            of_item: compared.labels(labels)?,
        };
        Ok(Self {
            names: compared
                .clips
                .iter()
                .map(|clip| clip.name.clone())
                .collect(),
            cut: compared.comparison.cut(clusters as usize),
            run: FileRun::new(kind, &labels),
            compared: Rc::clone(compared),
            labels,
        })
    }
}

#[wasm_bindgen]
impl FileHandle {
    /// A few milliseconds of work. Returns the part done; 1 when the file is whole.
    pub fn step(&mut self) -> f64 {
        let subject = Subject {
            names: &self.names,
            comparison: &self.compared.comparison,
            cut: &self.cut,
            labels: Some(&self.labels),
        };
        self.run.step(&subject, NUMBERS_A_STEP)
    }

    /// Hands over what follows the part before: about a megabyte, or nothing yet.
    #[wasm_bindgen(js_name = takePart)]
    pub fn take_part(&mut self) -> Vec<u8> {
        self.run.take_part()
    }
}
