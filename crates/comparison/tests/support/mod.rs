//! The reference values of the comparison, and values read from JSON.

#![allow(
    dead_code,
    unused_imports,
    reason = "not every test file uses all of this module"
)]

pub mod plain;

use std::fs;

use comparison::dendrogram::Merge;
use comparison::feature::Vector;
use serde_json::Value;
pub use test_support::{data_folder, indices, numbers};

/// The reference values of the comparison, where there is test data.
pub fn golden() -> Option<Value> {
    let path = data_folder()?.join("compare.golden.json");
    let text = fs::read_to_string(path).expect("a readable file");
    Some(serde_json::from_str(&text).expect("JSON"))
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
