//! `keypose features`: the posture variation of each file, as a table, JSON or an array.

use std::io::{self, BufWriter, Write};

use anyhow::Result;
use comparison::feature::Vector;
use comparison::report::{VERSION, feature_parameters, features_csv, features_npy};
use result_text::json::Json;

use crate::arguments::Features;
use crate::surveys::Surveys;

/// Writes the features of all files that can be compared. Returns whether every file could be read.
///
/// # Errors
/// An option that cannot be, or output that cannot be written.
pub fn write(wanted: &Features, threads: usize) -> Result<bool> {
    let all = Surveys::of(&wanted.paths, &wanted.overrides, threads)?;
    let distance = wanted.distance();
    let features: Vec<Vector> = all
        .files
        .iter()
        .map(|file| *distance.vector(&file.feature))
        .collect();
    let mut out = BufWriter::new(io::stdout());
    match (wanted.json, wanted.npy) {
        (true, _) => out.write_all(json_lines(&all, &features, wanted).as_bytes())?,
        (_, true) => out.write_all(&features_npy(&features))?,
        _ => out.write_all(features_csv(&all.names, &features, distance).as_bytes())?,
    }
    out.flush()?;
    Ok(all.all_good)
}

fn json_lines(all: &Surveys, features: &[Vector], wanted: &Features) -> String {
    let files = all.names.iter().zip(&all.files).zip(features);
    let lines = files.map(|((name, file), feature)| {
        let object = Json::object([
            ("file", name.as_str().into()),
            ("performer", file.performer.into()),
            ("sha256", file.sha256.as_str().into()),
            ("version", VERSION.into()),
            (
                "parameters",
                Json::Object(feature_parameters(wanted.distance())),
            ),
            ("frames", file.frames.into()),
            ("feature", Json::list(*feature)),
        ]);
        object.text() + "\n"
    });
    lines.collect()
}
