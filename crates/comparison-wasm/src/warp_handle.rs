//! Two clips on their way along each other: postures go in, the warping is made step by step, and
//! arrays come out.

use comparison::warping::{Warped, Warping, WarpingError, mirror_postures};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::failure;

/// Pairs of frames compared in one step.
const CELLS_A_STEP: usize = 1 << 17;

/// One warping in this memory. Free it once, with `free()`. Frames count from the first of the postures.
#[wasm_bindgen]
pub struct WarpHandle {
    warping: Option<Warping>,
    warped: Option<Warped>,
}

#[wasm_bindgen]
impl WarpHandle {
    /// Makes ready to warp b onto a: frames × 16 joints × 3, in body heights in the pelvis frame. `band`:
    /// the most frames that the path may leave the diagonal. Throws the failure of clips that are too
    /// long for each other.
    #[wasm_bindgen(constructor)]
    pub fn new(a: &[f64], b: &[f64], band: Option<f64>, mirror_b: bool) -> Result<Self, JsError> {
        // A band that is no number of frames is none.
        let band = band.filter(|band| *band >= 0.0).map(|band| band as usize);
        let warping = match mirror_b {
            true => Warping::new(a, &mirror_postures(b), band),
            false => Warping::new(a, b, band),
        };
        Ok(Self {
            warping: Some(warping.map_err(|error| refused(&error))?),
            warped: None,
        })
    }

    /// A few milliseconds of work. Returns the part done; 1 when the warping is there.
    pub fn step(&mut self) -> f64 {
        let Some(warping) = &mut self.warping else {
            return 1.0;
        };
        let done = warping.step(CELLS_A_STEP);
        if done >= 1.0 {
            self.warped = self.warping.take().map(Warping::finish);
        }
        done
    }

    /// The distance along the path, in body heights.
    pub fn distance(&self) -> Result<f64, JsError> {
        Ok(self.warped()?.distance)
    }

    /// The frame of a at each step of the path.
    #[wasm_bindgen(js_name = pathA)]
    pub fn path_a(&self) -> Result<Vec<i32>, JsError> {
        Ok(frames(&self.warped()?.path_a))
    }

    /// The frame of b.
    #[wasm_bindgen(js_name = pathB)]
    pub fn path_b(&self) -> Result<Vec<i32>, JsError> {
        Ok(frames(&self.warped()?.path_b))
    }

    /// How far a is ahead at each step.
    pub fn ahead(&self) -> Result<Vec<f64>, JsError> {
        Ok(self.warped()?.ahead.clone())
    }

    /// Steps × parts of the body: mean joint distance in body heights.
    #[wasm_bindgen(js_name = partDistances)]
    pub fn part_distances(&self) -> Result<Vec<f32>, JsError> {
        let distances = self.warped()?.part_distances.iter().flatten();
        Ok(distances.map(|distance| *distance as f32).collect())
    }

    /// Where the colours of the parts end.
    #[wasm_bindgen(js_name = fullColour)]
    pub fn full_colour(&self) -> Result<f64, JsError> {
        Ok(self.warped()?.full_colour)
    }
}

impl WarpHandle {
    fn warped(&self) -> Result<&Warped, JsError> {
        let warped = self.warped.as_ref();
        warped.ok_or_else(|| failure::misuse("step must have said 1"))
    }
}

fn frames(path: &[usize]) -> Vec<i32> {
    path.iter().map(|frame| *frame as i32).collect()
}

fn refused(error: &WarpingError) -> JsError {
    match error {
        WarpingError::NoFrames => failure::misuse("a warping needs frames"),
        WarpingError::TooManyCells { cells, most } => {
            let expected = format!("at most {most} pairs of frames: a narrower band");
            failure::refused("band", &cells.to_string(), &expected)
        }
    }
}
