//! The folder of test data, which is not part of the repository, and the values read from JSON.

#![allow(dead_code, reason = "not every test file uses all of this module")]

pub mod plain;

use std::fs;
use std::path::PathBuf;

use comparison::dendrogram::Merge;
use comparison::feature::Vector;
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

/// The reference values of the comparison, where there is test data.
pub fn golden() -> Option<Value> {
    let path = data_folder()?.join("compare.golden.json");
    let text = fs::read_to_string(path).expect("a readable file");
    Some(serde_json::from_str(&text).expect("JSON"))
}

/// A list of numbers.
pub fn numbers(value: &Value) -> Vec<f64> {
    let list = value.as_array().expect("a list");
    list.iter()
        .map(|number| number.as_f64().expect("a number"))
        .collect()
}

/// A list of whole numbers.
pub fn indices(value: &Value) -> Vec<usize> {
    let list = value.as_array().expect("a list");
    let as_index = |number: &Value| number.as_u64().expect("a whole number") as usize;
    list.iter().map(as_index).collect()
}

/// A list of features.
pub fn vectors(value: &Value) -> Vec<Vector> {
    let list = value.as_array().expect("a list");
    list.iter()
        .map(|row| numbers(row).try_into().expect("twelve numbers"))
        .collect()
}

/// A linkage matrix as SciPy writes it.
pub fn merges(value: &Value) -> Vec<Merge> {
    let rows = value.as_array().expect("a list").iter();
    rows.map(|row| {
        let row = numbers(row);
        Merge {
            left: row[0] as usize,
            right: row[1] as usize,
            height: row[2],
            size: row[3] as usize,
        }
    })
    .collect()
}

/// Whether two numbers agree to `tolerance` of the other.
pub fn is_close(one: f64, other: f64, tolerance: f64) -> bool {
    (one - other).abs() <= tolerance * other.abs() + 1e-13
}
