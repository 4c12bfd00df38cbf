//! The folder of test data, which is not part of the repository.

use std::path::PathBuf;

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
