//! The command, and folders for it.

#![allow(
    dead_code,
    unused_imports,
    reason = "not every test file uses all of this module"
)]

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

pub use test_support::{data_folder, numbers};

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
