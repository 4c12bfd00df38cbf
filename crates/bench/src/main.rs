//! Times of the core on one processor core: a number of runs and the paths of files go in; for each
//! file one line of JSON comes out, with the milliseconds of every run of reading and of analysing.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "it is a command")]

use std::process::ExitCode;
use std::{env, fs};

use bench::timing::timed;
use motion::analysis::{self, Decisions};
use motion::bvh::Reader;
use motion::clip::Clip;
use motion::keypose::Options;
use motion::report::json::Json;

/// Bytes that the reader is given at a time, as the command gives them.
const SLICE_BYTES: usize = 4 << 20;

fn main() -> ExitCode {
    let mut arguments = env::args().skip(1);
    let Some(runs) = arguments.next().and_then(|runs| runs.parse().ok()) else {
        eprintln!("bench RUNS FILE…");
        return ExitCode::FAILURE;
    };
    for path in arguments {
        match times(&path, runs) {
            Ok(line) => println!("{line}"),
            Err(message) => {
                eprintln!("{path}: {message}");
                return ExitCode::FAILURE;
            }
        }
    }
    ExitCode::SUCCESS
}

fn times(path: &str, runs: usize) -> Result<String, String> {
    let bytes = fs::read(path).map_err(|error| error.to_string())?;
    let clip = read(&bytes)?;
    let reading = timed(runs, || read(&bytes).map(|clip| clip.frames));
    let analysing = timed(runs, || keyposes(&clip));
    let line = Json::object([
        ("path", path.into()),
        ("bytes", bytes.len().into()),
        ("frames", clip.frames.into()),
        ("keyposes", keyposes(&clip).into()),
        ("readMs", Json::list(reading)),
        ("analyseMs", Json::list(analysing)),
    ]);
    Ok(line.text())
}

fn read(bytes: &[u8]) -> Result<Clip, String> {
    let mut reader = Reader::new(Some(bytes.len() as u64));
    for slice in bytes.chunks(SLICE_BYTES) {
        reader.push(slice).map_err(|error| error.to_string())?;
    }
    reader.finish().map_err(|error| error.to_string())
}

fn keyposes(clip: &Clip) -> usize {
    let analysis = analysis::analyse(clip, &Decisions::default(), &Options::default());
    let performers = analysis.map_or_else(|_| Vec::new(), |found| found.performers);
    let counts = performers.iter().map(|one| &one.keyposes);
    counts
        .map(|found| found.as_ref().map_or(0, |some| some.keyposes().len()))
        .sum()
}
