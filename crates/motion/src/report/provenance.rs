//! What a result was made with: the version of the core and every parameter.

use super::json::{Json, number};
use crate::keypose::Options;

/// The version of this crate, which all results name.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// The parameters, each by its name in [`Options`].
pub fn parameters(options: &Options) -> Json {
    let mut members: Vec<(&'static str, Json)> = numbers(options)
        .map(|(name, value)| (name, value.into()))
        .into();
    members.push(("selection", options.selection.name().into()));
    Json::Object(members)
}

/// The parameters as one field of a table: `low_pass_hz=10 … selection=automatic`.
pub fn parameters_text(options: &Options) -> String {
    let mut text = String::new();
    for (name, value) in numbers(options) {
        text.push_str(&format!("{name}={} ", number(value)));
    }
    text + "selection=" + options.selection.name()
}

fn numbers(options: &Options) -> [(&'static str, f64); 7] {
    [
        ("low_pass_hz", options.low_pass_hz),
        ("trend_hz", options.trend_hz),
        ("scale_max_hz", options.scale_max_hz),
        ("scale_min_hz", options.scale_min_hz),
        ("scale_ratio", options.scale_ratio),
        ("depth_floor", options.depth_floor),
        ("mojena_k", options.mojena_k),
    ]
}
