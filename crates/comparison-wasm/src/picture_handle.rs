//! A part of the matrix on its way to a picture: items go in, the picture is made step by step, and mean
//! distances come out.

use std::rc::Rc;

use comparison::picture::{Picture, PictureRun, Region};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::compared::Compared;

/// Cells of a picture that are looked at in one step.
const CELLS_A_STEP: usize = 1 << 18;

/// One picture in this memory. Free it once, with `free()`.
#[wasm_bindgen]
pub struct PictureHandle {
    compared: Rc<Compared>,
    run: Option<PictureRun>,
    picture: Picture,
}

impl PictureHandle {
    pub(crate) fn new(
        compared: &Rc<Compared>,
        rows: &[i32],
        columns: &[i32],
        most: u32,
    ) -> Result<Self, JsError> {
        let region = Region {
            rows: compared.items(rows)?,
            columns: compared.items(columns)?,
            most: most as usize,
        };
        Ok(Self {
            run: Some(PictureRun::new(&compared.comparison.distances, region)),
            compared: Rc::clone(compared),
            picture: Picture::default(),
        })
    }
}

#[wasm_bindgen]
impl PictureHandle {
    /// A few milliseconds of work. Returns the part done; 1 when the picture is there.
    pub fn step(&mut self) -> f64 {
        let Some(run) = &mut self.run else {
            return 1.0;
        };
        let done = run.step(&self.compared.comparison.distances, CELLS_A_STEP);
        if done >= 1.0 {
            self.picture = self.run.take().map(PictureRun::finish).unwrap_or_default();
        }
        done
    }

    /// Rows of the picture.
    pub fn rows(&self) -> u32 {
        self.picture.rows as u32
    }

    /// Columns of the picture.
    pub fn columns(&self) -> u32 {
        self.picture.columns as u32
    }

    /// Hands the picture over: mean distances, row by row.
    #[wasm_bindgen(js_name = takeValues)]
    pub fn take_values(&mut self) -> Vec<f32> {
        std::mem::take(&mut self.picture.values)
    }
}
