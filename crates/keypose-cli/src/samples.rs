//! Sample motions written into a folder, each with its true keyposes.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail};
use sample_motions::{Mark, Sample, bvh, true_keyposes};

/// Writes the samples with these ids, or all; `ID.bvh` and `ID.json` each.
///
/// # Errors
/// An id that does not exist, or a folder that cannot be written to.
pub fn write_all(folder: &Path, ids: &[String]) -> Result<()> {
    for id in ids {
        if !Sample::all().any(|sample| sample.id() == *id) {
            let known: Vec<String> = Sample::all().map(|sample| sample.id()).collect();
            bail!("there is no sample {id}; there are {}", known.join(", "));
        }
    }
    fs::create_dir_all(folder).with_context(|| folder.display().to_string())?;
    Sample::all()
        .filter(|sample| ids.is_empty() || ids.contains(&sample.id()))
        .try_for_each(|sample| write(folder, &sample))
}

fn write(folder: &Path, sample: &Sample) -> Result<()> {
    let id = sample.id();
    let file = format!("{id}.bvh");
    let keyposes: Vec<serde_json::Value> = true_keyposes(sample).iter().map(mark).collect();
    let marks = serde_json::json!({ "file": file, "keyposes": keyposes });
    fs::write(folder.join(&file), bvh(sample)).with_context(|| file.clone())?;
    fs::write(folder.join(format!("{id}.json")), format!("{marks}\n")).with_context(|| id)
}

fn mark(mark: &Mark) -> serde_json::Value {
    if mark.from == mark.to {
        mark.from.into()
    } else {
        vec![mark.from, mark.to].into()
    }
}
