//! Which files a call is about, and what they are called: folders, links, namesakes, what is missing.

mod support;

use std::fs;
use std::path::Path;

use serde_json::Value;
use support::{folder, keypose, text};

/// A sample of few frames at that place.
fn write_sample(path: &Path, id: &str) {
    let folder = path.parent().unwrap();
    fs::create_dir_all(folder).unwrap();
    keypose(&["samples", folder.to_str().unwrap(), id]);
    fs::remove_file(folder.join(format!("{id}.json"))).unwrap();
    fs::rename(folder.join(format!("{id}.bvh")), path).unwrap();
}

fn compared(arguments: &[&str]) -> Value {
    let output = keypose(&[&["compare", "--json"], arguments].concat());
    serde_json::from_slice(&output.stdout).expect("JSON")
}

fn clips(arguments: &[&str]) -> Vec<String> {
    let set = compared(arguments);
    let clips = set["clips"].as_array().unwrap().iter();
    clips
        .map(|clip| clip.as_str().unwrap().to_owned())
        .collect()
}

#[test]
fn namesakes_are_told_apart_by_their_folders() {
    let folder = folder("namesakes");
    write_sample(&folder.join("day-1/anna/walk.bvh"), "walk-hik-30");
    write_sample(&folder.join("day-2/anna/walk.bvh"), "walk-poser-30");
    write_sample(&folder.join("day-2/anna/run.bvh"), "run-hik-30");
    let days = ["day-1", "day-2"].map(|day| folder.join(day).to_str().unwrap().to_owned());
    let expected = ["day-1/anna/walk.bvh", "anna/run.bvh", "day-2/anna/walk.bvh"];
    assert_eq!(clips(&[&days[0], &days[1]]), expected);
    let files = days.map(|day| day + "/anna/walk.bvh");
    assert_eq!(clips(&[&files[0], &files[1]]), [expected[0], expected[2]]);
}

#[test]
fn a_file_that_is_named_twice_is_taken_once() {
    let folder = folder("twice");
    write_sample(&folder.join("set/walk.bvh"), "walk-hik-30");
    write_sample(&folder.join("set/run.bvh"), "run-hik-30");
    let set = folder.join("set");
    let (set, walk) = (set.to_str().unwrap(), set.join("walk.bvh"));
    let walk = walk.to_str().unwrap();
    assert_eq!(clips(&[walk, walk]), ["walk.bvh"]);
    assert_eq!(clips(&[walk, set]), ["walk.bvh", "run.bvh"]);
    let around = format!("{set}/../set/walk.bvh");
    assert_eq!(clips(&[set, &around]), ["run.bvh", "walk.bvh"]);
}

#[test]
fn what_is_missing_is_told_and_the_others_are_done() {
    let folder = folder("missing");
    write_sample(&folder.join("set/walk.bvh"), "walk-hik-30");
    let (set, nowhere) = (folder.join("set"), folder.join("nowhere"));
    let paths = [nowhere.to_str().unwrap(), set.to_str().unwrap()];
    for command in ["inspect", "keyposes", "features", "compare"] {
        let output = keypose(&[command, paths[0], paths[1]]);
        assert_eq!(output.status.code(), Some(1), "{command}");
        let error = text(&output.stderr);
        assert!(error.starts_with(&format!("{}: ", paths[0])), "{error}");
        assert_eq!(error.lines().count(), 1, "{error}");
        assert!(text(&output.stdout).contains("walk.bvh"), "{command}");
    }
}

#[cfg(unix)]
#[test]
fn links_are_followed_but_not_in_circles() {
    use std::os::unix::fs::symlink;
    let folder = folder("links");
    write_sample(&folder.join("set/walk.bvh"), "walk-hik-30");
    write_sample(&folder.join("others/run.bvh"), "run-hik-30");
    let set = folder.join("set");
    let path = set.to_str().unwrap();
    symlink(folder.join("others"), set.join("linked")).unwrap();
    assert_eq!(clips(&[path]), ["linked/run.bvh", "walk.bvh"]);
    symlink(&set, set.join("circle")).unwrap();
    symlink(folder.join("nowhere"), set.join("dead.bvh")).unwrap();
    let output = keypose(&["features", path]);
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(text(&output.stdout).lines().count(), 3);
    let error = text(&output.stderr);
    assert!(
        error.contains("circle: a link to a folder that it lies in\n"),
        "{error}"
    );
    assert_eq!(error.matches("dead.bvh: ").count(), 1, "{error}");
}

#[test]
fn a_folder_without_motions_is_told() {
    let folder = folder("no-motions");
    fs::write(folder.join("notes.txt"), "nothing").unwrap();
    let output = keypose(&["compare", "--json", folder.to_str().unwrap()]);
    assert!(output.status.success());
    assert!(text(&output.stderr).ends_with("no-motions: no .bvh files there\n"));
    let set: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(
        (&set["cluster_count"], &set["clips"]),
        (&0.into(), &Value::Array(vec![]))
    );
}

#[test]
fn the_folder_of_a_file_is_its_label_however_it_is_named() {
    let folder = folder("label");
    write_sample(&folder.join("walks/a.bvh"), "walk-hik-30");
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_keypose"))
        .args(["compare", "--json", "--labels", "folder", "a.bvh"])
        .current_dir(folder.join("walks"))
        .output()
        .unwrap();
    let set: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(set["labels"], serde_json::json!(["walks"]));
}

#[test]
fn scores_without_labels_are_not_defined() {
    let folder = folder("unlabelled");
    write_sample(&folder.join("walk.bvh"), "walk-hik-30");
    write_sample(&folder.join("run.bvh"), "run-hik-30");
    let path = folder.to_str().unwrap();
    for (pattern, without) in [("x{label}", 2), ("wa{label}", 1), ("{label}", 0)] {
        let output = keypose(&["compare", "--json", "--labels", pattern, path]);
        let set: Value = serde_json::from_slice(&output.stdout).unwrap();
        let evaluation = &set["evaluation"];
        for member in ["accuracy", "best_reachable", "recall", "precision", "f"] {
            assert_eq!(
                evaluation[member].is_null(),
                without == 2,
                "{pattern} {member}"
            );
        }
        let said = format!("{without} of 2 clips have no label; they are left out of the scores\n");
        let expected = if without > 0 { said.as_str() } else { "" };
        assert_eq!(text(&output.stderr), expected, "{pattern}");
    }
}
