//! Writes samples as .bvh files, each with a .json of its true keyposes, into a folder.
//!
//! `cargo run --release -p sample-motions --example write -- FOLDER [ID…]`; without an id all are written.

use sample_motions::{Mark, Sample, bvh, true_keyposes};
use std::path::Path;
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let mut arguments = env::args().skip(1);
    let folder = arguments
        .next()
        .ok_or_else(|| io::Error::other("usage: write FOLDER [ID…]"))?;
    let ids: Vec<String> = arguments.collect();
    fs::create_dir_all(&folder)?;
    for sample in Sample::all().filter(|s| ids.is_empty() || ids.contains(&s.id())) {
        write(Path::new(&folder), &sample)?;
    }
    Ok(())
}

fn write(folder: &Path, sample: &Sample) -> io::Result<()> {
    let id = sample.id();
    fs::write(folder.join(format!("{id}.bvh")), bvh(sample))?;
    let marks: Vec<String> = true_keyposes(sample).iter().map(mark).collect();
    let json = format!(
        "{{\"file\": \"{id}.bvh\", \"keyposes\": [{}]}}\n",
        marks.join(", ")
    );
    fs::write(folder.join(format!("{id}.json")), json)
}

fn mark(mark: &Mark) -> String {
    if mark.from == mark.to {
        mark.from.to_string()
    } else {
        format!("[{}, {}]", mark.from, mark.to)
    }
}
