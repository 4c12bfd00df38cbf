//! The command and folders for it; the folder of test data, which is not part of the repository.

#![allow(dead_code, reason = "not every test file uses all of this module")]

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

use serde_json::Value;

/// A folder of its own for a test, emptied before use.
pub fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// What the command does with these arguments.
pub fn keypose(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_keypose"))
        .args(arguments)
        .output()
        .unwrap()
}

/// Bytes as text.
pub fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// The folder named by `KEYPOSE_DATA`, else `../shared/data` beside the project; none, and a line
/// that says so, where it is absent.
pub fn data_folder() -> Option<PathBuf> {
    let beside_project = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/data");
    let folder = std::env::var_os("KEYPOSE_DATA").map_or(beside_project.into(), PathBuf::from);
    if folder.is_dir() {
        return Some(folder);
    }
    eprintln!(
        "skipped: no test data in {} (KEYPOSE_DATA)",
        folder.display()
    );
    None
}

/// A list of numbers.
pub fn numbers(value: &Value) -> Vec<f64> {
    let list = value.as_array().expect("a list");
    list.iter()
        .map(|number| number.as_f64().expect("a number"))
        .collect()
}
