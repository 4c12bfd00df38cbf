//! The commands `features` and `compare` as a person runs them, on samples.

mod support;

use std::fs;
use std::path::Path;

use serde_json::Value;
use support::{folder, keypose, numbers, text};

const SAMPLES: [&str; 4] = [
    "walk-hik-30",
    "walk-poser-30",
    "slow-dance-vrm-30",
    "run-hik-30",
];

/// A folder with some samples, and its name.
fn samples(name: &str) -> (std::path::PathBuf, String) {
    let folder = folder(name);
    let path = folder.to_str().unwrap().to_owned();
    let output = keypose(&[&["samples", &path], &SAMPLES[..]].concat());
    assert!(output.status.success(), "{}", text(&output.stderr));
    (folder, path)
}

fn json(bytes: &[u8]) -> Value {
    serde_json::from_slice(bytes).expect("JSON")
}

/// The shape and the numbers of an `.npy` file of 64-bit floats.
fn read_npy(bytes: &[u8]) -> ([usize; 2], Vec<f64>) {
    assert_eq!(&bytes[..8], b"\x93NUMPY\x01\x00");
    let end = 10 + usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
    assert_eq!(end % 64, 0);
    let header = text(&bytes[10..end]);
    assert!(
        header.contains("'descr': '<f8', 'fortran_order': False"),
        "{header}"
    );
    let shape = header.split(['(', ')']).nth(1).expect("a shape");
    let mut sides = shape
        .split(", ")
        .map(|side| side.parse().expect("a number"));
    let values = bytes[end..].chunks_exact(8);
    let values = values.map(|value| f64::from_le_bytes(value.try_into().unwrap()));
    (
        [sides.next().unwrap(), sides.next().unwrap()],
        values.collect(),
    )
}

#[test]
fn features_are_the_same_in_every_form_and_those_of_keyposes() {
    let (_, path) = samples("features");
    let table = text(&keypose(&["features", &path, "--csv"]).stdout);
    let rows: Vec<Vec<&str>> = table.lines().map(|row| row.split(',').collect()).collect();
    assert_eq!(rows[0][..3], ["clip", "mean_xx", "mean_yy"]);
    let of_table = rows[1..].iter().flat_map(|row| &row[1..13]);
    let of_table: Vec<f64> = of_table.map(|field| field.parse().unwrap()).collect();
    let (shape, values) = read_npy(&keypose(&["features", &path, "--npy"]).stdout);
    assert_eq!((shape, values), ([4, 12], of_table));
    let lines = text(&keypose(&["features", &path, "--json"]).stdout);
    for (line, row) in lines.lines().zip(&rows[1..]) {
        let member = format!("\"feature\":[{}]", row[1..13].join(","));
        assert!(line.contains(&member), "{line} {member}");
    }
    let lines: Vec<Value> = lines.lines().map(|line| json(line.as_bytes())).collect();
    assert_eq!(lines.len(), SAMPLES.len());
    let keyposes = text(&keypose(&["keyposes", &path, "--json"]).stdout);
    for (line, other) in lines.iter().zip(keyposes.lines()) {
        let other = json(other.as_bytes());
        for member in ["file", "feature", "sha256", "version", "performer"] {
            assert_eq!(line[member], other[member], "{member}");
        }
    }
    let across = text(&keypose(&["features", &path, "--csv", "--across-rigs"]).stdout);
    assert!(across.contains("distance=posture-variation across_rigs=true\r\n"));
    assert_ne!(across, table);
}

#[test]
fn a_set_is_one_object() {
    let (_, path) = samples("set");
    let output = keypose(&[
        "compare",
        &path,
        "--json",
        "--labels",
        "{label}-*-*",
        "--clusters",
        "2",
    ]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let set = json(&output.stdout);
    let clips = [
        "run-hik-30.bvh",
        "slow-dance-vrm-30.bvh",
        "walk-hik-30.bvh",
        "walk-poser-30.bvh",
    ];
    assert_eq!(set["clips"], serde_json::json!(clips));
    assert_eq!(
        set["labels"],
        serde_json::json!(["run", "slow", "walk", "walk"])
    );
    assert_eq!(set["condensed"].as_array().unwrap().len(), 6);
    assert_eq!(set["merges"].as_array().unwrap().len(), 3);
    assert_eq!(set["merges"][2][3], 4);
    assert_eq!(
        (&set["cluster_count"], &set["parameters"]["cut"]),
        (&2.into(), &"user".into())
    );
    let evaluation = &set["evaluation"];
    assert_eq!(evaluation["labelled"], 4);
    assert_eq!(evaluation["single"], serde_json::json!(["run", "slow"]));
    let sum: f64 = evaluation["confusion"]
        .as_array()
        .unwrap()
        .iter()
        .flat_map(numbers)
        .sum();
    assert_eq!(sum, 4.0);
    let unlabelled = json(&keypose(&["compare", &path, "--json"]).stdout);
    assert_eq!(unlabelled["labels"], Value::Null);
    assert!(unlabelled.get("evaluation").is_none());
}

#[test]
fn the_same_bytes_for_any_number_of_threads() {
    let (_, path) = samples("compare-threads");
    for form in ["--json", "--csv", "--newick"] {
        let one = keypose(&["compare", &path, form, "--threads", "1"]).stdout;
        assert!(!one.is_empty());
        assert_eq!(
            one,
            keypose(&["compare", &path, form, "--threads", "3"]).stdout
        );
    }
}

#[test]
fn tables_trees_and_text_name_every_clip() {
    let (_, path) = samples("forms");
    for form in [&["--csv", "--labels", "folder"][..], &["--newick"], &[]] {
        let output = keypose(&[&["compare", &path], form].concat());
        let text = text(&output.stdout);
        for sample in SAMPLES {
            assert!(text.contains(sample), "{form:?} {text}");
        }
    }
    let table = text(&keypose(&["compare", &path, "--csv", "--labels", "folder"]).stdout);
    assert!(
        table.starts_with("clip,label,cluster,nearest,nearest_label,distance,is_right,version,")
    );
    assert_eq!(
        table.matches(",forms,").count(),
        8,
        "own label and that of the nearest"
    );
}

/// A clip of one frame, and one of a body that is not human.
fn write_incomparable(folder: &Path) {
    let sample = fs::read_to_string(folder.join("walk-hik-30.bvh")).unwrap();
    let (head, motion) = sample.split_once("MOTION").unwrap();
    let row = motion.lines().nth(3).unwrap();
    let still = format!("{head}MOTION\nFrames: 1\nFrame Time: 0.033333\n{row}\n");
    fs::write(folder.join("still.bvh"), still).unwrap();
    let box_joint = "HIERARCHY\nROOT box\n{\n OFFSET 0 0 0\n CHANNELS 3 Xposition Yposition Zposition\n \
                     End Site\n {\n  OFFSET 0 1 0\n }\n}\nMOTION\nFrames: 3\nFrame Time: 0.1\n\
                     0 0 0\n1 0 0\n2 0 0\n";
    fs::write(folder.join("box.bvh"), box_joint).unwrap();
}

#[test]
fn bad_and_incomparable_files_say_why_and_the_others_are_compared() {
    let (folder, path) = samples("incomparable");
    write_incomparable(&folder);
    let output = keypose(&["compare", &path, "--json"]);
    assert!(output.status.success(), "no file is broken");
    let error = text(&output.stderr);
    assert!(
        error.contains("box.bvh: left out: the body is not human"),
        "{error}"
    );
    assert!(
        error.contains("still.bvh: left out: the motion has fewer than two frames"),
        "{error}"
    );
    let set = json(&output.stdout);
    assert_eq!(set["clips"].as_array().unwrap().len(), SAMPLES.len());
    let expected = serde_json::json!([
        { "clip": "box.bvh", "reason": "not-human" },
        { "clip": "still.bvh", "reason": "too-short" },
    ]);
    assert_eq!(set["left_out"], expected);
    fs::write(
        folder.join("bad.bvh"),
        "HIERARCHY\nROOT hip\n{\n  OFFSET 0 x 0\n",
    )
    .unwrap();
    let output = keypose(&["features", &path, "--csv"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stderr).contains("bad.bvh:4:12: "));
    assert_eq!(text(&output.stdout).lines().count(), 1 + SAMPLES.len());
}

#[test]
fn one_clip_or_none_is_a_set_too() {
    let folder = folder("small");
    let path = folder.to_str().unwrap();
    for (clips, merges) in [(0, 0), (1, 0), (2, 1), (3, 2)] {
        if clips > 0 {
            keypose(&["samples", path, SAMPLES[clips - 1]]);
        }
        for options in [&[][..], &["--linkage", "average"], &["--mirror"]] {
            let arguments = [&["compare", path, "--json", "--labels", "folder"], options].concat();
            let output = keypose(&arguments);
            assert!(output.status.success(), "{}", text(&output.stderr));
            let set = json(&output.stdout);
            assert_eq!(
                set["merges"].as_array().unwrap().len(),
                merges,
                "{clips} {options:?}"
            );
            assert_eq!(
                set["leaves"].as_array().unwrap().len(),
                clips,
                "{clips} {options:?}"
            );
        }
    }
}

#[test]
fn options_that_cannot_be_are_refused() {
    for (options, message) in [
        (
            &["--mirror", "--linkage", "ward"][..],
            "the mirror-aware distance",
        ),
        (
            &["--mirror", "--clusters", "bic"],
            "the mirror-aware distance",
        ),
        (
            &["--clusters", "0"],
            "expected a whole number from 1, bic or mojena",
        ),
        (&["--labels", "{label}*"], "nothing between"),
        (&["--labels", "walk"], "{label} is missing"),
        (&["--distance", "length"], "posture-variation"),
    ] {
        let output = keypose(&[&["compare", "nowhere"], options].concat());
        assert!(!output.status.success(), "{options:?}");
        let error = text(&output.stderr);
        assert!(error.contains(message), "{options:?}: {error}");
    }
}
