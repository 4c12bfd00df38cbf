//! Trees over many vectors: what to do and how many go in; a line of JSON with milliseconds comes out, from the
//! vectors to the tree, with the sum of the tree's heights.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "it is a command")]

use std::hint::black_box;
use std::process::ExitCode;
use std::{env, fs};

use bench::timing::once;
use bench::vectors::{WIDTH, heaped};
use comparison::condensed::Condensed;
use comparison::cut::bic::bic;
use comparison::distance::euclidean;
use comparison::distances::Distances;
use comparison::feature::Vector;
use comparison::leaf_order::optimal;
use comparison::linkage::{group_average_in_place, ward};
use comparison::map::of_vectors;
use comparison::picture::{Picture, PictureRun, Region};
use motion::report::json::Json;

const USAGE: &str = "comparison vectors COUNT FILE
comparison kodama|keypose ward|average COUNT
comparison stages COUNT RUNS";

/// Rows and columns of the picture of a large matrix.
const PIXELS: usize = 1024;

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let done = match words[..] {
        ["vectors", count, path] => vectors(count, path),
        ["kodama", method, count] => by_kodama(method, count),
        ["keypose", method, count] => by_keypose(method, count),
        ["stages", count, runs] => stages(count, runs),
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

fn by_keypose(method: &str, count: &str) -> Option<String> {
    let vectors = vectors_of(count)?;
    let make = match method {
        "ward" => |vectors: &[Vector]| ward(vectors),
        "average" => |vectors: &[Vector]| group_average_in_place(Condensed::of_vectors(vectors)),
        _ => return None,
    };
    let (tree, ms) = once(|| make(&vectors));
    Some(line(ms, tree.merges.iter().map(|merge| merge.height).sum()))
}

/// Milliseconds of each stage after the vectors, in each run.
fn stages(count: &str, runs: &str) -> Option<String> {
    let vectors = vectors_of(count)?;
    let runs = runs.parse().ok()?;
    let tree = ward(&vectors);
    let between = |a: usize, b: usize| euclidean(&vectors[a], &vectors[b]);
    let distances = Distances::of_vectors(vectors.clone(), false);
    let leaves = optimal(&tree, &between).leaves;
    let each = |work: &dyn Fn()| Json::list((0..runs).map(|_| once(work).1));
    let found = Json::object([
        ("ward", each(&|| drop(black_box(ward(&vectors))))),
        ("order", each(&|| drop(black_box(optimal(&tree, &between))))),
        ("clusters", each(&|| drop(black_box(bic(&vectors, &tree))))),
        (
            "picture",
            each(&|| drop(black_box(picture(&distances, &leaves)))),
        ),
        ("map", each(&|| drop(black_box(of_vectors(&vectors))))),
    ]);
    Some(found.text())
}

/// The whole matrix, as the app draws it.
fn picture(distances: &Distances, leaves: &[usize]) -> Picture {
    let region = Region {
        rows: leaves.to_vec(),
        columns: leaves.to_vec(),
        most: PIXELS,
    };
    let mut run = PictureRun::new(distances, region);
    while run.step(distances, usize::MAX) < 1.0 {}
    run.finish()
}

fn vectors_of(count: &str) -> Option<Vec<Vector>> {
    let values = heaped(count.parse().ok()?);
    let (vectors, _) = values.as_chunks::<WIDTH>();
    Some(vectors.to_vec())
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
