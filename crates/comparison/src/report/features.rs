//! Features as a table: names and features go in, CSV or `.npy` come out.

use result_text::csv::field;
use result_text::json::number;

use super::npy;
use super::provenance::{VERSION, feature_parameters_text};
use crate::distance::Distance;
use crate::feature::{FEATURE_LENGTH, Vector};

/// The columns of a feature.
const HEADER: &str = "clip,mean_xx,mean_yy,mean_zz,mean_xy,mean_yz,mean_zx,deviation_xx,\
                      deviation_yy,deviation_zz,deviation_xy,deviation_yz,deviation_zx,version,\
                      parameters\r\n";

/// One row for each clip: those of its vectors that the distance compares.
pub fn features_csv(names: &[String], features: &[Vector], distance: Distance) -> String {
    let end = format!("{VERSION},{}", feature_parameters_text(distance));
    let mut text = HEADER.to_owned();
    for (name, feature) in names.iter().zip(features) {
        let numbers = feature.map(number).join(",");
        text.push_str(&format!("{},{numbers},{end}\r\n", field(name)));
    }
    text
}

/// Clips × 12.
pub fn features_npy(features: &[Vector]) -> Vec<u8> {
    let values = features.iter().flatten().copied();
    npy::table(features.len(), FEATURE_LENGTH, values)
}
