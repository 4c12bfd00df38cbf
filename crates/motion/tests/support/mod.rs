//! The folder of test data, which is not part of the repository.

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
#[allow(dead_code, reason = "not every test file uses all of this module")]
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
