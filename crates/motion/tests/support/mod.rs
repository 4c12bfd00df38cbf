//! The golden values, and the analysed part of a motion.

#![allow(
    dead_code,
    unused_imports,
    reason = "not every test file uses all of this module"
)]

use std::fs;
use std::path::PathBuf;

use motion::body::{Body, PelvisFrame, PoseTable};
use motion::clip::Clip;
use motion::rest::{self, LeadingRest};
use motion::track::PelvisTrack;
use serde_json::Value;
pub use test_support::{data_folder, indices, numbers};

/// The golden values of every clip: its name and the JSON object.
pub fn golden_clips() -> Vec<(String, Value)> {
    let Some(folder) = data_folder() else {
        return Vec::new();
    };
    let mut paths: Vec<PathBuf> = fs::read_dir(folder.join("golden"))
        .expect("a folder of golden values")
        .map(|entry| entry.expect("an entry").path())
        .collect();
    paths.sort();
    paths
        .iter()
        .map(|path| {
            let text = fs::read_to_string(path).expect("a readable file");
            let name = path
                .file_stem()
                .expect("a name")
                .to_string_lossy()
                .into_owned();
            (name, serde_json::from_str(&text).expect("JSON"))
        })
        .collect()
}

/// Asserts that the largest difference over the largest value is at most `tolerance`.
pub fn assert_close(name: &str, found: &[f64], golden: &[f64], tolerance: f64) {
    assert_eq!(found.len(), golden.len(), "{name}: length");
    let largest = golden
        .iter()
        .fold(0.0, |largest: f64, value| largest.max(value.abs()));
    let differences = found.iter().zip(golden).map(|(a, b)| (a - b).abs());
    let difference = differences.fold(0.0, f64::max);
    assert!(
        difference <= tolerance * largest,
        "{name}: {:e}",
        difference / largest
    );
}

/// The analysed part of a motion.
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code, reason = "not every test file uses all of this module")]
pub struct Analysed {
    /// What was left out before it.
    pub leading: LeadingRest,
    /// The pelvis frame of the analysed frames.
    pub frame: PelvisFrame,
    /// The analysed frames in it.
    pub track: PelvisTrack,
}

/// Pelvis frame and leading rest pose with all frames of `table`, then the frame once more without
/// the frames left out.
#[allow(dead_code, reason = "not every test file uses all of this module")]
pub fn analysed(clip: &Clip, body: &Body, table: PoseTable) -> Analysed {
    let mut frame = PelvisFrame::new(clip, 0, body, &table, 0);
    let start = table.first_track(&frame, rest::FRAMES_LOOKED_AT);
    let leading = rest::leading_rest_frames(&start, table.frames(), body.is_human());
    if leading.frames > 0 {
        frame = PelvisFrame::new(clip, 0, body, &table, leading.frames);
    }
    let track = table.into_track(&frame, leading.frames);
    Analysed {
        leading,
        frame,
        track,
    }
}
