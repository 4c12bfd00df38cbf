//! The command as a person runs it: samples written by itself, keyposes, errors, order.

mod support;

use std::fs;

use serde_json::Value;
use support::{folder, keypose, text};

#[test]
fn samples_are_found_again_by_their_marks() {
    let folder = folder("samples");
    let path = folder.to_str().unwrap();
    assert!(
        keypose(&["samples", path, "walk-hik-30", "slow-dance-vrm-30"])
            .status
            .success()
    );
    let output = keypose(&["keyposes", path, "--json", "--marks", path]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let lines: Vec<Value> = text(&output.stdout)
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    let files: Vec<&str> = lines
        .iter()
        .map(|line| line["file"].as_str().unwrap())
        .collect();
    assert_eq!(files, ["slow-dance-vrm-30.bvh", "walk-hik-30.bvh"]);
    for line in &lines {
        assert!(
            line["evaluation"]["f"].as_f64().unwrap() >= 0.9,
            "{}",
            line["file"]
        );
        assert_eq!(line["body"]["kind"], "human");
        assert_eq!(line["feature"].as_array().unwrap().len(), 12);
    }
}

#[test]
fn a_bad_file_is_one_line_and_the_others_are_done() {
    let folder = folder("bad");
    let path = folder.to_str().unwrap();
    keypose(&["samples", path, "walk-hik-30"]);
    fs::write(
        folder.join("a.bvh"),
        "HIERARCHY\nROOT hip\n{\n  OFFSET 0 x 0\n",
    )
    .unwrap();
    let output = keypose(&["keyposes", path, "--csv"]);
    assert_eq!(output.status.code(), Some(1));
    let error = text(&output.stderr);
    assert_eq!(error.lines().count(), 1, "{error}");
    assert!(error.contains("a.bvh:4:12: "), "{error}");
    let table = text(&output.stdout);
    assert!(table.starts_with("file,performer,number,frame,time_s,intensity,rank,"));
    assert!(table.lines().count() > 5);
}

#[test]
fn candidates_and_traces_are_tables_of_their_own() {
    let folder = folder("tables");
    let path = folder.to_str().unwrap();
    keypose(&["samples", path, "walk-hik-30", "walk-poser-30"]);
    for (option, start) in [
        (
            "--candidates",
            "file,performer,number,frame,time_s,intensity,",
        ),
        (
            "--traces",
            "file,performer,candidate,scale_hz,frame,place,u",
        ),
    ] {
        let table = text(&keypose(&["keyposes", path, "--csv", option]).stdout);
        assert!(table.starts_with(start), "{option}");
        assert_eq!(
            table.matches("file,").count(),
            1,
            "one header for all files"
        );
        let lines = text(&keypose(&["keyposes", path, "--json", option]).stdout);
        assert_eq!(lines.lines().count(), 2, "{option}");
        let refused = keypose(&["keyposes", path, option]);
        assert_eq!(refused.status.code(), Some(2), "{option} needs a form");
    }
}

#[test]
fn a_joint_can_be_decided() {
    let folder = folder("joint");
    let path = folder.to_str().unwrap();
    keypose(&["samples", path, "walk-poser-30"]);
    let wrist = |arguments: &[&str]| {
        let output = keypose(&[&["keyposes", path, "--json"], arguments].concat());
        let line: Value = serde_json::from_slice(&output.stdout).unwrap();
        let joints = line["body"]["joints"].as_array().unwrap().clone();
        let wrist = joints.into_iter().find(|one| one["role"] == "left_wrist");
        (wrist.unwrap(), line["keyposes"].clone())
    };
    let (found, keyposes) = wrist(&[]);
    assert_eq!(
        (&found["joint"], &found["source"]),
        (&"lHand".into(), &"name".into())
    );
    let (decided, others) = wrist(&["--joint", "left_wrist=lForeArm"]);
    assert_eq!(
        (&decided["joint"], &decided["source"]),
        (&"lForeArm".into(), &"user".into())
    );
    assert_ne!(keyposes, others);
    for (wish, message) in [
        ("left_wrist", "--joint is left_wrist; expected ROLE=JOINT"),
        ("tail=lHand", "--joint: tail is no part of the body"),
        ("left_wrist=paw", "--joint: there is no joint paw"),
    ] {
        let output = keypose(&["keyposes", path, "--json", "--joint", wish]);
        assert_eq!(output.status.code(), Some(1));
        assert!(
            text(&output.stderr).contains(message),
            "{}",
            text(&output.stderr)
        );
    }
}

#[test]
fn the_same_bytes_for_any_number_of_threads() {
    let folder = folder("threads");
    let path = folder.to_str().unwrap();
    keypose(&[
        "samples",
        path,
        "walk-hik-30",
        "walk-poser-30",
        "walk-vrm-30",
    ]);
    let one = keypose(&["keyposes", path, "--json", "--threads", "1"]);
    let three = keypose(&["keyposes", path, "--json", "--threads", "3"]);
    assert!(!one.stdout.is_empty());
    assert_eq!(one.stdout, three.stdout);
}

#[test]
fn an_option_that_cannot_be_is_named() {
    let output = keypose(&["keyposes", "--scale-ratio", "1.5", "nowhere.bvh"]);
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(
        text(&output.stderr),
        "keypose: scale_ratio is 1.5; expected a number above 0 and below 1\n"
    );
}

#[test]
fn a_file_that_does_not_exist_is_named() {
    let output = keypose(&["inspect", "nowhere.bvh"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stderr).contains("nowhere.bvh"));
}

#[test]
fn inspect_shows_body_and_rest() {
    let folder = folder("inspect");
    let path = folder.to_str().unwrap();
    keypose(&["samples", path, "walk-poser-30"]);
    let output = text(&keypose(&["inspect", path]).stdout);
    assert!(output.contains("human"), "{output}");
    assert!(output.contains("left_shoulder   lShldr (name)"), "{output}");
}
