//! A comparison that is done: clips and numbers of JavaScript go in, items and labels come out.

use comparison::comparison::Comparison;
use wasm_bindgen::JsError;

use crate::clips::NamedClip;
use crate::failure;

/// A comparison and the clips that its items are.
pub struct Compared {
    /// The comparison.
    pub comparison: Comparison,
    /// The clip of each item; their ids rise.
    pub clips: Vec<NamedClip>,
}

impl Compared {
    /// The item that a clip is; none where it is not compared.
    pub fn item(&self, clip: i32) -> Option<usize> {
        let item = self.clips.binary_search_by_key(&clip, |one| one.id);
        item.ok()
    }

    /// The item that a clip must be.
    pub fn item_of(&self, clip: i32) -> Result<usize, JsError> {
        self.item(clip).ok_or_else(failure::compared_again)
    }

    /// Items by their numbers.
    pub fn items(&self, numbers: &[i32]) -> Result<Vec<usize>, JsError> {
        let items = self.clips.len();
        let item = |number: &i32| usize::try_from(*number).ok().filter(|item| *item < items);
        let found: Option<Vec<usize>> = numbers.iter().map(item).collect();
        found.ok_or_else(failure::compared_again)
    }

    /// Labels by their numbers, one for each item.
    pub fn labels(&self, numbers: &[i32]) -> Result<Vec<Option<usize>>, JsError> {
        if numbers.len() != self.clips.len() {
            return Err(failure::compared_again());
        }
        let label = |number: &i32| usize::try_from(*number).ok();
        Ok(numbers.iter().map(label).collect())
    }
}
