//! Features as a table: names and features go in, CSV or `.npy` come out.

use result_text::csv::field;
use result_text::json::number;

use super::npy;
use super::provenance::{VERSION, feature_parameters_text};
use crate::distance::Distance;
use crate::feature::{FEATURE_LENGTH, Vector};

/// The columns of a feature.
pub(super) const HEADER: &str = "clip,mean_xx,mean_yy,mean_zz,mean_xy,mean_yz,mean_zx,deviation_xx,\
                      deviation_yy,deviation_zz,deviation_xy,deviation_yz,deviation_zx,version,\
                      parameters\r\n";

/// One row for each clip: those of its vectors that the distance compares.
pub fn features_csv(names: &[String], features: &[Vector], distance: Distance) -> String {
    let mut text = HEADER.to_owned();
    for (name, feature) in names.iter().zip(features) {
        push_row(&mut text, name, feature, distance);
    }
    text
}

/// Adds the row of a clip.
pub(super) fn push_row(text: &mut String, name: &str, feature: &Vector, distance: Distance) {
    let numbers = feature.map(number).join(",");
    let (name, parameters) = (field(name), feature_parameters_text(distance));
    text.push_str(&format!("{name},{numbers},{VERSION},{parameters}\r\n"));
}

/// Clips × 12.
pub fn features_npy(features: &[Vector]) -> Vec<u8> {
    let mut bytes = npy::head(features.len(), FEATURE_LENGTH);
    for feature in features {
        npy::push_row(&mut bytes, feature);
    }
    bytes
}
