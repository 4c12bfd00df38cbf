//! Settings: plain objects of JavaScript go in, the core's types come out. An unknown name is an error.

use comparison::distance::{Dissimilarity, Distance};
use comparison::settings::{Linkage, Settings};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::failure;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &'static str = "import type { ComparisonSettings } from '../comparison-types';";

#[wasm_bindgen]
extern "C" {
    /// `ComparisonSettings` of TypeScript.
    #[wasm_bindgen(typescript_type = "ComparisonSettings")]
    pub type JsSettings;
    #[wasm_bindgen(method, getter, structural)]
    fn distance(this: &JsSettings) -> JsDistance;
    #[wasm_bindgen(method, getter, structural)]
    fn linkage(this: &JsSettings) -> String;

    /// `DistanceSettings` of TypeScript.
    type JsDistance;
    #[wasm_bindgen(method, getter, structural)]
    fn measure(this: &JsDistance) -> String;
    #[wasm_bindgen(method, getter, structural, js_name = mirrorAware)]
    fn mirror_aware(this: &JsDistance) -> bool;
    #[wasm_bindgen(method, getter, structural, js_name = acrossRigs)]
    fn across_rigs(this: &JsDistance) -> bool;
}

/// The core's settings.
pub fn settings(from: &JsSettings) -> Result<Settings, JsError> {
    let settings = Settings {
        distance: distance(&from.distance())?,
        linkage: linkage(&from.linkage())?,
        cut: None,
    };
    match settings.validate() {
        Ok(()) => Ok(settings),
        Err(error) => Err(failure::refused(
            "linkage",
            settings.linkage.name(),
            &error.to_string(),
        )),
    }
}

fn distance(from: &JsDistance) -> Result<Distance, JsError> {
    let distance = Distance::PostureVariation(Dissimilarity {
        mirror_aware: from.mirror_aware(),
        across_rigs: from.across_rigs(),
    });
    let measure = from.measure();
    match measure == distance.name() {
        true => Ok(distance),
        false => Err(failure::refused("measure", &measure, distance.name())),
    }
}

fn linkage(name: &str) -> Result<Linkage, JsError> {
    let found = Linkage::ALL.into_iter().find(|one| one.name() == name);
    found.ok_or_else(|| failure::refused("linkage", name, "ward or average"))
}
