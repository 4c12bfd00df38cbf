//! The folder of test data, which is not part of the repository.

#![allow(dead_code, reason = "not every test file uses all of this module")]

use std::fs;
use std::path::PathBuf;

use serde_json::Value;

/// The folder named by `KEYPOSE_DATA`, else `../shared/data` beside the project; none, and a line
/// that says so, where it is absent.
pub fn data_folder() -> Option<PathBuf> {
    let beside_project = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/data");
    let folder = std::env::var_os("KEYPOSE_DATA").map_or(beside_project.into(), PathBuf::from);
    if folder.is_dir() {
        return Some(folder);
    }
    #[expect(clippy::print_stderr, reason = "a skipped test says so")]
    {
        eprintln!(
            "skipped: no test data in {} (KEYPOSE_DATA)",
            folder.display()
        );
    }
    None
}

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

/// A list of numbers.
pub fn numbers(value: &Value) -> Vec<f64> {
    let list = value.as_array().expect("a list");
    list.iter()
        .map(|number| number.as_f64().expect("a number"))
        .collect()
}

/// A list of frames or indices.
pub fn indices(value: &Value) -> Vec<usize> {
    let list = value.as_array().expect("a list");
    list.iter()
        .map(|number| number.as_u64().expect("an index") as usize)
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
