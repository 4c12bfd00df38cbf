//! Decisions and options: plain objects of JavaScript go in, the core's types come out. An unknown
//! name is an error; what is absent is as found, or the default.

use motion::analysis::{Decisions, JointDecision, SettingsError};
use motion::body::Role;
use motion::keypose::{Options, SelectionRule};
use motion::report::json::Json;
use motion::world::{Unit, Up};
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &'static str = "import type { Decisions, MethodOptions } from '../types';";

#[wasm_bindgen]
extern "C" {
    /// `Decisions` of TypeScript.
    #[wasm_bindgen(typescript_type = "Decisions")]
    pub type JsDecisions;
    #[wasm_bindgen(method, getter, structural, js_name = frameRateHz)]
    fn frame_rate_hz(this: &JsDecisions) -> Option<f64>;
    #[wasm_bindgen(method, getter, structural, js_name = leadingRestFrames)]
    fn leading_rest_frames(this: &JsDecisions) -> Option<f64>;
    #[wasm_bindgen(method, getter, structural)]
    fn up(this: &JsDecisions) -> Option<String>;
    #[wasm_bindgen(method, getter, structural)]
    fn unit(this: &JsDecisions) -> Option<String>;
    #[wasm_bindgen(method, getter, structural, js_name = groundHeight)]
    fn ground_height(this: &JsDecisions) -> Option<f64>;
    #[wasm_bindgen(method, getter, structural)]
    fn joints(this: &JsDecisions) -> Option<Vec<JsJoint>>;

    /// `JointDecision` of TypeScript.
    type JsJoint;
    #[wasm_bindgen(method, getter, structural)]
    fn performer(this: &JsJoint) -> f64;
    #[wasm_bindgen(method, getter, structural)]
    fn role(this: &JsJoint) -> String;
    #[wasm_bindgen(method, getter, structural)]
    fn joint(this: &JsJoint) -> f64;

    /// `MethodOptions` of TypeScript.
    #[wasm_bindgen(typescript_type = "MethodOptions")]
    pub type JsOptions;
    #[wasm_bindgen(method, getter, structural, js_name = lowPassHz)]
    fn low_pass_hz(this: &JsOptions) -> Option<f64>;
    #[wasm_bindgen(method, getter, structural, js_name = scaleMaxHz)]
    fn scale_max_hz(this: &JsOptions) -> Option<f64>;
    #[wasm_bindgen(method, getter, structural, js_name = scaleMinHz)]
    fn scale_min_hz(this: &JsOptions) -> Option<f64>;
    #[wasm_bindgen(method, getter, structural, js_name = scaleRatio)]
    fn scale_ratio(this: &JsOptions) -> Option<f64>;
    #[wasm_bindgen(method, getter, structural)]
    fn selection(this: &JsOptions) -> Option<String>;
}

/// The default of every parameter, as JSON: `MethodSettings` of TypeScript.
#[wasm_bindgen(js_name = methodDefaults)]
pub fn method_defaults() -> String {
    let default = Options::default();
    Json::object([
        ("lowPassHz", Json::Number(default.low_pass_hz)),
        ("scaleMaxHz", Json::Number(default.scale_max_hz)),
        ("scaleMinHz", Json::Number(default.scale_min_hz)),
        ("scaleRatio", Json::Number(default.scale_ratio)),
        ("selection", default.selection.name().into()),
    ])
    .text()
}

/// The core's decisions.
pub fn decisions(from: &JsDecisions) -> Result<Decisions, SettingsError> {
    Ok(Decisions {
        frame_rate_hz: from.frame_rate_hz(),
        leading_rest_frames: leading_rest_frames(from)?,
        up: from.up().map(up).transpose()?,
        unit: from.unit().map(unit).transpose()?,
        ground_height: from.ground_height(),
        joints: joints(from.joints().unwrap_or_default())?,
    })
}

fn joints(from: Vec<JsJoint>) -> Result<Vec<JointDecision>, SettingsError> {
    let one = |one: JsJoint| {
        let role = one.role();
        Ok(JointDecision {
            performer: whole("joints", one.performer())?,
            role: Role::from_name(&role).ok_or(SettingsError {
                field: "joints",
                found: role,
                expected: "a part of the body, as left_wrist",
            })?,
            joint: whole("joints", one.joint())?,
        })
    };
    from.into_iter().map(one).collect()
}

/// The core's options.
pub fn options(from: &JsOptions) -> Result<Options, SettingsError> {
    let default = Options::default();
    Ok(Options {
        low_pass_hz: from.low_pass_hz().unwrap_or(default.low_pass_hz),
        scale_max_hz: from.scale_max_hz().unwrap_or(default.scale_max_hz),
        scale_min_hz: from.scale_min_hz().unwrap_or(default.scale_min_hz),
        scale_ratio: from.scale_ratio().unwrap_or(default.scale_ratio),
        selection: from.selection().map_or(Ok(default.selection), selection)?,
        ..default
    })
}

fn leading_rest_frames(from: &JsDecisions) -> Result<Option<usize>, SettingsError> {
    let frames = from.leading_rest_frames();
    frames
        .map(|frames| whole("leading_rest_frames", frames))
        .transpose()
}

fn whole(field: &'static str, number: f64) -> Result<usize, SettingsError> {
    let is_whole = number >= 0.0 && number <= f64::from(u32::MAX) && number.fract() == 0.0;
    is_whole.then_some(number as usize).ok_or(SettingsError {
        field,
        found: number.to_string(),
        expected: "a whole number from 0",
    })
}

fn up(name: String) -> Result<Up, SettingsError> {
    Up::from_name(&name).ok_or(SettingsError {
        field: "up",
        found: name,
        expected: "+X, -X, +Y, -Y, +Z or -Z",
    })
}

fn unit(name: String) -> Result<Unit, SettingsError> {
    let found = Unit::ALL.into_iter().find(|unit| unit_name(*unit) == name);
    found.ok_or(SettingsError {
        field: "unit",
        found: name,
        expected: "m, dm, cmu, inch, cm or mm",
    })
}

/// The name of a unit in TypeScript.
pub fn unit_name(unit: Unit) -> &'static str {
    match unit {
        Unit::Metre => "m",
        Unit::Decimetre => "dm",
        Unit::Cmu => "cmu",
        Unit::Inch => "inch",
        Unit::Centimetre => "cm",
        Unit::Millimetre => "mm",
    }
}

fn selection(name: String) -> Result<SelectionRule, SettingsError> {
    let found = SelectionRule::ALL
        .into_iter()
        .find(|rule| rule.name() == name);
    found.ok_or(SettingsError {
        field: "selection",
        found: name,
        expected: "automatic, literal or even-split",
    })
}
