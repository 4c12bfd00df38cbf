//! Trees over many vectors: what to do and how many go in; a line of JSON with milliseconds comes out, from the
//! vectors to the tree, with the sum of the tree's heights.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "it is a command")]

use std::process::ExitCode;
use std::{env, fs};

use bench::timing::once;
use bench::vectors::{WIDTH, heaped};
use motion::report::json::Json;

const USAGE: &str = "comparison vectors COUNT FILE
comparison kodama ward|average COUNT";

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let done = match words[..] {
        ["vectors", count, path] => vectors(count, path),
        ["kodama", method, count] => by_kodama(method, count),
        _ => None,
    };
    let Some(line) = done else {
        eprintln!("{USAGE}");
        return ExitCode::FAILURE;
    };
    println!("{line}");
    ExitCode::SUCCESS
}

/// Writes the vectors for a program that is none of ours.
fn vectors(count: &str, path: &str) -> Option<String> {
    let values = heaped(count.parse().ok()?);
    let bytes: Vec<u8> = values
        .iter()
        .flat_map(|value| value.to_le_bytes())
        .collect();
    fs::write(path, bytes).ok()?;
    Some(Json::object([("width", WIDTH.into())]).text())
}

fn by_kodama(method: &str, count: &str) -> Option<String> {
    let method = match method {
        "ward" => kodama::Method::Ward,
        "average" => kodama::Method::Average,
        _ => return None,
    };
    let values = heaped(count.parse().ok()?);
    let (heights, ms) = once(|| {
        let mut distances = distances(&values);
        let tree = kodama::linkage(&mut distances, values.len() / WIDTH, method);
        tree.steps().iter().map(|step| step.dissimilarity).sum()
    });
    Some(line(ms, heights))
}

/// Condensed, in the order of SciPy, which is kodama's.
fn distances(values: &[f64]) -> Vec<f64> {
    let vectors: Vec<&[f64]> = values.chunks_exact(WIDTH).collect();
    let mut condensed = Vec::with_capacity(vectors.len() * (vectors.len() - 1) / 2);
    for (place, a) in vectors.iter().enumerate() {
        condensed.extend(vectors[place + 1..].iter().map(|b| {
            let squares = a.iter().zip(*b).map(|(a, b)| (a - b) * (a - b));
            squares.sum::<f64>().sqrt()
        }));
    }
    condensed
}

fn line(ms: f64, heights: f64) -> String {
    Json::object([("ms", ms.into()), ("heights", heights.into())]).text()
}
