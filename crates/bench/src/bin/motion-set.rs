//! A large set of motions: a folder and a number of clips go in; the folder is filled with variations of the
//! sample motions, a folder below it for each motion. What is there already stays.

#![allow(clippy::print_stderr, reason = "it is a command")]

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::atomic::{AtomicU64, Ordering};
use std::{env, fs, io, thread};

use sample_motions::{Motion, Sample, Variation};

fn main() -> ExitCode {
    let mut arguments = env::args().skip(1);
    let (Some(folder), Some(count)) = (arguments.next(), arguments.next()) else {
        eprintln!("motion-set DIR COUNT");
        return ExitCode::FAILURE;
    };
    let written = count
        .parse()
        .map_err(io::Error::other)
        .and_then(|count| write_all(Path::new(&folder), count));
    if let Err(error) = written {
        eprintln!("{folder}: {error}");
        return ExitCode::FAILURE;
    }
    ExitCode::SUCCESS
}

fn write_all(folder: &Path, count: u64) -> io::Result<()> {
    for motion in Motion::ALL {
        fs::create_dir_all(folder.join(motion.id()))?;
    }
    let next = AtomicU64::new(0);
    let work = || {
        loop {
            let number = next.fetch_add(1, Ordering::Relaxed);
            if number >= count {
                return Ok(());
            }
            write(folder, number)?;
        }
    };
    let threads = thread::available_parallelism().map_or(1, usize::from);
    thread::scope(|scope| {
        let writers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        writers
            .into_iter()
            .try_for_each(|writer| writer.join().expect("a writer does not panic"))
    })
}

/// Whole or not at all: an interrupted run leaves no half file under the name.
fn write(folder: &Path, number: u64) -> io::Result<()> {
    let variation = Variation::numbered(number);
    let path = folder.join(place(&variation.sample, number));
    if path.exists() {
        return Ok(());
    }
    let part = path.with_extension("part");
    fs::write(&part, variation.bvh())?;
    fs::rename(part, path)
}

fn place(Sample { motion, rig, rate }: &Sample, number: u64) -> PathBuf {
    let name = format!("{number:05}-{}-{}.bvh", rig.id(), rate.hz());
    Path::new(motion.id()).join(name)
}
