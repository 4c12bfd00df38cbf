//! The recorded set through the command: every number that the reference values have.

mod support;

use serde_json::Value;
use support::{data_folder, keypose, numbers, text};

/// The set compared with these options beside `--json`, and the reference values.
fn compared(options: &[&str]) -> Option<(Value, Value)> {
    let data = data_folder()?;
    let golden = std::fs::read_to_string(data.join("compare.golden.json")).unwrap();
    let set = data.join("cmu");
    let arguments = [&["compare", "--json", set.to_str().unwrap()], options].concat();
    let output = keypose(&arguments);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let found = serde_json::from_slice(&output.stdout).expect("JSON");
    Some((found, serde_json::from_str(&golden).unwrap()))
}

fn assert_near(found: &[f64], expected: &[f64], what: &str) {
    assert_eq!(found.len(), expected.len(), "{what}");
    for (index, (found, expected)) in found.iter().zip(expected).enumerate() {
        let is_near = (found - expected).abs() <= 1e-9 * expected.abs().max(1e-2);
        assert!(is_near, "{what} {index}: {found}, expected {expected}");
    }
}

/// The numbers of a list of lists.
fn table(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().flat_map(numbers).collect()
}

/// Names without their ending.
fn names(value: &Value) -> Vec<String> {
    let list = value.as_array().unwrap().iter();
    let text = list.map(|name| name.as_str().unwrap());
    text.map(|name| name.trim_end_matches(".bvh").to_owned())
        .collect()
}

/// Whether two partitions put the same clips together.
fn assert_same_partition(found: &Value, expected: &Value) {
    let (found, expected) = (numbers(found), numbers(expected));
    assert_eq!(found.len(), expected.len());
    for a in 0..found.len() {
        for b in 0..a {
            let (here, there) = (found[a] == found[b], expected[a] == expected[b]);
            assert_eq!(here, there, "clips {a} and {b}");
        }
    }
}

fn assert_scores(found: &Value, expected: &Value) {
    for score in ["recall", "precision", "f"] {
        let values = [found, expected].map(|scores| scores[score].as_f64().unwrap());
        assert_near(&values[..1], &values[1..], score);
    }
}

#[test]
fn features_matrix_tree_and_scores_of_ward() {
    let Some((found, golden)) = compared(&["--labels", "{label}_*"]) else {
        return;
    };
    assert_eq!(names(&found["clips"]), names(&golden["clips"]));
    assert_eq!(found["labels"], golden["labels"]);
    assert_near(
        &table(&found["features"]),
        &table(&golden["features"]),
        "feature",
    );
    let condensed = [&found, &golden].map(|set| numbers(&set["condensed"]));
    assert_near(&condensed[0], &condensed[1], "condensed");
    assert_near(&table(&found["merges"]), &table(&golden["ward"]), "merge");
    assert_eq!(found["cluster_count"], golden["bic"]["clusters"]);
    assert_same_partition(&found["clusters"], &golden["bic"]["assignment"]);
    assert_near(
        &numbers(&found["bic"]),
        &numbers(&golden["bic"]["values"]),
        "bic",
    );
    let evaluation = &found["evaluation"];
    assert_scores(evaluation, &golden["bic"]);
    let accuracy =
        [&evaluation["accuracy"], &golden["accuracy"]].map(|value| value.as_f64().unwrap());
    assert_near(&accuracy[..1], &accuracy[1..], "accuracy");
    let neighbours = found["neighbours"].as_array().unwrap();
    let nearest: Vec<Value> = neighbours
        .iter()
        .map(|all| all[0]["clip"].clone())
        .collect();
    assert_eq!(names(&nearest.into()), names(&golden["nearest"]));
}

#[test]
fn leaf_order_costs_no_more_than_the_reference() {
    let Some((found, golden)) = compared(&[]) else {
        return;
    };
    let clips = found["clips"].as_array().unwrap().len();
    let condensed = numbers(&found["condensed"]);
    let at = |a: usize, b: usize| {
        let (row, column) = (a.min(b), a.max(b));
        condensed[row * (2 * clips - row - 1) / 2 + column - row - 1]
    };
    let leaves: Vec<usize> = numbers(&found["leaves"])
        .iter()
        .map(|leaf| *leaf as usize)
        .collect();
    let cost: f64 = leaves.windows(2).map(|pair| at(pair[0], pair[1])).sum();
    let reference = golden["ward_optimal_cost"].as_f64().unwrap();
    assert!(cost <= reference + 1e-9, "{cost}, reference {reference}");
    assert_eq!(found["order_is_optimal"], true);
}

#[test]
fn the_map_has_the_spread_of_the_reference() {
    let Some((found, golden)) = compared(&[]) else {
        return;
    };
    let scaling = &golden["classical_scaling"];
    let spread = [&found["map_spread"], &scaling["share_of_spread"]];
    let spread = spread.map(|value| value.as_f64().unwrap());
    assert_near(&spread[..1], &spread[1..], "spread");
    let places = table(&found["map"]);
    let along = |axis: usize| {
        places
            .iter()
            .skip(axis)
            .step_by(2)
            .map(|value| value * value)
    };
    let eigenvalues: Vec<f64> = (0..2).map(|axis| along(axis).sum()).collect();
    assert_near(
        &eigenvalues,
        &numbers(&scaling["eigenvalues"]),
        "eigenvalue",
    );
}

#[test]
fn group_average_and_its_cut() {
    let options = ["--linkage", "average", "--labels", "{label}_*"];
    let Some((found, golden)) = compared(&options) else {
        return;
    };
    let mojena = &golden["mojena_average"];
    assert_near(
        &table(&found["merges"]),
        &table(&golden["average"]),
        "merge",
    );
    assert_eq!(found["cluster_count"], mojena["clusters"]);
    assert_eq!(found["parameters"]["mojena_k"], mojena["k"]);
    assert_same_partition(&found["clusters"], &mojena["assignment"]);
    assert_scores(&found["evaluation"], mojena);
}

#[test]
fn distances_to_mirror_images() {
    let Some((found, golden)) = compared(&["--mirror"]) else {
        return;
    };
    let clips = names(&found["clips"]);
    let condensed = numbers(&found["condensed"]);
    for (pair, expected) in golden["mirrored_distance"].as_object().unwrap() {
        let places: Vec<usize> = pair
            .split(' ')
            .map(|name| clips.iter().position(|clip| clip == name).unwrap())
            .collect();
        let (row, column) = (places[0], places[1]);
        let index = row * (2 * clips.len() - row - 1) / 2 + column - row - 1;
        let plain = numbers(&golden["condensed"])[index];
        let expected = expected.as_f64().unwrap().min(plain);
        assert_near(&condensed[index..=index], &[expected], pair);
    }
}
