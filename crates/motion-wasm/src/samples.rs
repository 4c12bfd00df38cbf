//! The sample motions: their catalogue and their bytes.

use motion::report::json::Json;
use sample_motions::{Entry, catalogue};
use wasm_bindgen::prelude::wasm_bindgen;

/// The samples offered, as JSON: id, motion, fileName.
#[wasm_bindgen(js_name = sampleCatalogue)]
pub fn sample_catalogue() -> String {
    Json::list(catalogue().iter().map(entry)).text()
}

/// The bytes of a sample; undefined where none has that id.
#[wasm_bindgen(js_name = sampleBvh)]
pub fn sample_bvh(id: &str) -> Option<Vec<u8>> {
    let entry = catalogue().iter().find(|entry| entry.id == id)?;
    Some(sample_motions::bvh(&entry.sample))
}

fn entry(entry: &Entry) -> Json {
    Json::object([
        ("id", entry.id.into()),
        ("motion", entry.sample.motion.id().into()),
        ("fileName", format!("{}.bvh", entry.id).into()),
    ])
}
