//! Linkage against SciPy's on data with ties; `fixtures/make_linkage.py` made what is expected.

mod support;

use comparison::condensed::Condensed;
use comparison::dendrogram::{Dendrogram, Merge};
use comparison::feature::{FEATURE_LENGTH, Vector};
use comparison::linkage;
use serde_json::Value;
use support::{indices, is_close, merges, numbers, vectors};

/// Heights may differ by the rounding of the distances they are made of.
const TOLERANCE: f64 = 1e-12;

#[test]
fn trees_are_those_of_scipy() {
    let fixture = fixture();
    for case in fixture["cases"].as_array().expect("a list") {
        let name = format!("{} {}", case["name"], case["method"]);
        assert_same(&name, &linked(case).merges, &merges(&case["merges"]));
    }
}

/// Above a thousand vectors the distances are those of centroids, rounded otherwise than SciPy's: the
/// copies among these are ties that do not hang on rounding.
#[test]
fn tree_of_many_vectors_is_that_of_scipy() {
    let fixture = fixture();
    let large = &fixture["large"];
    let seed = large["seed"].as_u64().expect("a seed") as u32;
    let count = large["count"].as_u64().expect("a count") as usize;
    let tree = linkage::ward(&with_copies(seed, count));
    let heights = numbers(&large["heights"]);
    let pairs = large["pairs"].as_array().expect("a list");
    for ((merge, &height), pair) in tree.merges.iter().zip(&heights).zip(pairs) {
        assert_eq!(vec![merge.left, merge.right], indices(pair));
        assert!(is_close(merge.height, height, TOLERANCE));
    }
    assert_eq!(tree.merges.len(), heights.len());
}

fn fixture() -> Value {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures/linkage.json");
    let text = std::fs::read_to_string(path).expect("a readable file");
    serde_json::from_str(&text).expect("JSON")
}

fn linked(case: &Value) -> Dendrogram {
    if let Some(values) = case.get("condensed") {
        let values = numbers(values);
        let pairs = |items: usize| items * (items - 1) / 2;
        let items = (2..).find(|&items| pairs(items) == values.len());
        let items = items.expect("a number of items");
        return linkage::group_average(&Condensed { items, values });
    }
    let vectors = vectors(&case["vectors"]);
    if case["method"] == "ward" {
        return linkage::ward(&vectors);
    }
    linkage::group_average(&Condensed::of_vectors(&vectors))
}

fn assert_same(name: &str, found: &[Merge], expected: &[Merge]) {
    assert_eq!(found.len(), expected.len(), "{name}");
    for (index, (found, expected)) in found.iter().zip(expected).enumerate() {
        assert_eq!(
            (found.left, found.right, found.size),
            (expected.left, expected.right, expected.size),
            "{name}, merge {index}"
        );
        let is_same = is_close(found.height, expected.height, TOLERANCE);
        assert!(is_same, "{name}: {} {}", found.height, expected.height);
    }
}

/// The vectors of the script's large case.
fn with_copies(seed: u32, count: usize) -> Vec<Vector> {
    let mut state = seed;
    let mut next = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from((state >> 8) % 1000) / 1000.0
    };
    let mut points: Vec<Vector> = Vec::with_capacity(count);
    for _ in 0..count {
        let mut point = [0.0; FEATURE_LENGTH];
        point.fill_with(&mut next);
        points.push(point);
    }
    for index in (7..count).step_by(7) {
        points[index] = points[index / 7];
    }
    points
}
