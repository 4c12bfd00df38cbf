//! Files and folders given in; the motion capture files in them out, in order.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use walkdir::WalkDir;

/// One file to work on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InputFile {
    /// Where it is.
    pub path: PathBuf,
    /// What output calls it: the path below the folder given, or the file's own name.
    pub label: String,
}

/// All files, in the order given; those of a folder in the order of their names.
///
/// # Errors
/// A path that does not exist, or a folder that cannot be listed.
pub fn collect(paths: &[PathBuf]) -> Result<Vec<InputFile>> {
    let mut files = Vec::new();
    for path in paths {
        if path.is_dir() {
            list_folder(path, &mut files)?;
        } else {
            path.metadata()
                .with_context(|| format!("{}", path.display()))?;
            files.push(InputFile {
                path: path.clone(),
                label: file_name(path),
            });
        }
    }
    Ok(files)
}

fn list_folder(folder: &Path, files: &mut Vec<InputFile>) -> Result<()> {
    for entry in WalkDir::new(folder).follow_links(true).sort_by_file_name() {
        let entry = entry.with_context(|| format!("{}", folder.display()))?;
        if entry.file_type().is_file() && is_motion(entry.path()) {
            let below = entry.path().strip_prefix(folder).unwrap_or(entry.path());
            let label = below.to_string_lossy().replace('\\', "/");
            files.push(InputFile {
                path: entry.into_path(),
                label,
            });
        }
    }
    Ok(())
}

fn is_motion(path: &Path) -> bool {
    path.extension()
        .is_some_and(|extension| extension.eq_ignore_ascii_case("bvh"))
}

/// The last part of a path, as text.
pub fn file_name(path: &Path) -> String {
    path.file_name()
        .unwrap_or(path.as_os_str())
        .to_string_lossy()
        .into_owned()
}
