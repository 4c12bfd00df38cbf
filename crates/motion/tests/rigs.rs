//! Real rigs: which joints are the body, its height, the frames left out and the up axis, against
//! answers given by hand. Also the leading rest frames of every file of the test data.

mod support;

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use motion::body::{self, Role, TableBuilder};
use motion::clip::Clip;
use motion::feature::posture_variation;
use motion::keypose::{Options, extract};
use motion::speed::motion_speed;
use motion::world;
use serde_json::Value;
use support::Analysed;

struct Found {
    clip: Clip,
    body: body::Body,
    up: Option<&'static str>,
    analysed: Analysed,
}

fn analyse(path: &Path, overrides: &[(Role, usize)]) -> Found {
    let bytes = fs::read(path).expect("a readable file");
    let clip = motion::bvh::parse(&bytes).expect("a motion");
    let body = body::find(&clip, 0, overrides);
    let mut builder = TableBuilder::new(&clip, 0, &body);
    while !builder.step(100) {}
    let table = builder.finish();
    let up = world::up_axis(&table.footing).map(world::Up::name);
    let analysed = support::analysed(&clip, &body, table);
    Found {
        clip,
        body,
        up,
        analysed,
    }
}

fn rigs() -> Vec<(std::path::PathBuf, Value)> {
    let Some(folder) = support::data_folder() else {
        return Vec::new();
    };
    let text = fs::read_to_string(folder.join("rigs.golden.json")).expect("the answers");
    let all: Vec<Value> = serde_json::from_str(&text).expect("JSON");
    all.into_iter()
        .map(|rig| {
            let name = rig["file"].as_str().expect("a name").to_owned();
            (folder.join("rigs").join(name), rig)
        })
        .collect()
}

/// Roles whose joint is neither the expected one nor one of the alternatives.
fn wrong_joints(found: &Found, rig: &Value) -> Vec<String> {
    let labels = found.clip.performers[0].skeleton.labels();
    let mut wrong = Vec::new();
    for role in Role::ALL {
        let expected = rig["body"][role.name()].as_str().expect("a joint");
        let alternatives = rig["alternatives"][role.name()].as_array();
        let joint = found
            .body
            .joint(*role)
            .map_or("none", |joint| labels[joint].as_str());
        let is_alternative =
            alternatives.is_some_and(|names| names.iter().any(|name| name.as_str() == Some(joint)));
        if joint != expected && !is_alternative {
            wrong.push(format!(
                "{}: {} is {joint}, not {expected}",
                rig["file"],
                role.name()
            ));
        }
    }
    wrong
}

#[test]
fn every_human_rig_is_mapped_without_a_hand() {
    let mut wrong = Vec::new();
    for (path, rig) in rigs() {
        let found = analyse(&path, &[]);
        if found.body.is_human() != (rig["kind"] == "human") {
            wrong.push(format!(
                "{}: {:?} is not {}",
                rig["file"], found.body.kind, rig["kind"]
            ));
        } else if found.body.is_human() {
            wrong.extend(wrong_joints(&found, &rig));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn height_rest_frames_and_up_axis_are_those_of_the_rigs() {
    let mut wrong = Vec::new();
    for (path, rig) in rigs() {
        if rig["kind"] != "human" {
            continue;
        }
        let found = analyse(&path, &[]);
        let height = rig["body_height"].as_f64().expect("a height");
        let ours = found.analysed.frame.height;
        if (ours - height).abs() > 1e-8 * height {
            wrong.push(format!("{}: height {ours}, not {height}", rig["file"]));
        }
        let leading = found.analysed.leading.frames;
        if Some(leading as u64) != rig["leading_rest_frames"].as_u64() {
            wrong.push(format!("{}: {leading} leading frames", rig["file"]));
        }
        if found.up != rig["up_in_motion"].as_str() {
            wrong.push(format!("{}: up is {:?}", rig["file"], found.up));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn leading_rest_frames_of_every_file() {
    let Some(folder) = support::data_folder() else {
        return;
    };
    let table = fs::read_to_string(folder.join("rest_frames.tsv")).expect("the table");
    let mut wrong = Vec::new();
    for line in table.lines().skip(1) {
        let (file, frames) = line.split_once('\t').expect("two columns");
        let leading = analyse(&folder.join(file), &[]).analysed.leading;
        if Ok(leading.frames) != frames.trim().parse() {
            wrong.push(format!("{file}: {leading:?}, not {frames}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn pelvis_coordinates_and_height_of_the_golden_clips() {
    let Some(folder) = support::data_folder() else {
        return;
    };
    for (name, golden) in support::golden_clips() {
        let found = analyse(&folder.join("cmu").join(format!("{name}.bvh")), &[]);
        let height = golden["body_height"].as_f64().expect("a height");
        assert!(
            (found.analysed.frame.height - height).abs() <= 1e-9 * height,
            "{name}"
        );
        let expected: BTreeMap<String, Vec<f64>> =
            serde_json::from_value(golden["pelvis_coordinates"].clone()).expect("rows");
        let largest = expected
            .values()
            .flatten()
            .fold(0.0_f64, |most, value| most.max(value.abs()));
        let track = body::track(&found.clip, 0, &found.body, &found.analysed.frame, 0);
        for (frame, row) in expected {
            let ours = track.frame(frame.parse().expect("a frame"));
            for (ours, expected) in ours.iter().zip(&row) {
                assert!(
                    (ours - expected).abs() <= 1e-9 * largest,
                    "{name} {frame}: {ours}, not {expected}"
                );
            }
        }
    }
}

/// The file's answer for each role, as overrides.
fn named_joints(path: &Path, rig: &Value) -> Vec<(Role, usize)> {
    let clip = motion::bvh::parse(&fs::read(path).expect("a readable file")).expect("a motion");
    let labels = clip.performers[0].skeleton.labels();
    let joint = |role: &Role| {
        let name = rig["body"][role.name()].as_str()?;
        labels.iter().position(|label| label == name)
    };
    let roles = Role::ALL.iter();
    roles
        .map(|role| (*role, joint(role).expect("a joint of that name")))
        .collect()
}

fn numbers(value: &Value) -> Vec<f64> {
    let list = value.as_array().expect("a list").iter();
    list.map(|number| number.as_f64().expect("a number"))
        .collect()
}

/// The largest difference over the largest value; infinite where the lengths differ.
fn difference(ours: &[f64], expected: &[f64]) -> f64 {
    if ours.len() != expected.len() {
        return f64::INFINITY;
    }
    let largest = expected
        .iter()
        .fold(f64::MIN_POSITIVE, |most, value| most.max(value.abs()));
    let pairs = ours.iter().zip(expected);
    pairs
        .map(|(ours, expected)| (ours - expected).abs())
        .fold(0.0, f64::max)
        / largest
}

/// Everything from the bytes of a file to its keyposes, with the joints that `golden` names.
fn compare_all(name: &str, found: &Found, golden: &Value, wrong: &mut Vec<String>) {
    let Analysed { track, .. } = &found.analysed;
    let rate_hz = found.clip.frame_rate_hz();
    let speed = motion_speed(track, rate_hz, 10.0).values;
    let keyposes = extract(&speed, rate_hz, &Options::default()).expect("valid options");
    let in_file = |frames: &[usize]| -> Vec<f64> {
        frames
            .iter()
            .map(|frame| (frame + track.first_frame) as f64)
            .collect()
    };
    let figures = [
        ("candidates", in_file(&keyposes.candidates), 0.0),
        ("keyposes", in_file(&keyposes.keyposes()), 0.0),
        ("intensity", keyposes.intensity.clone(), 1e-7),
        ("feature", posture_variation(track).to_vec(), 1e-8),
        ("speed", speed.clone(), 1e-9),
    ];
    for (field, ours, tolerance) in figures {
        if golden[field].is_array() {
            let difference = difference(&ours, &numbers(&golden[field]));
            if difference > tolerance {
                wrong.push(format!("{name}: {field} differs by {difference:e}"));
            }
        }
    }
}

#[test]
fn keyposes_and_features_of_the_rigs_from_their_bytes() {
    let mut wrong = Vec::new();
    for (path, rig) in rigs() {
        if rig["candidates"].is_array() {
            let found = analyse(&path, &named_joints(&path, &rig));
            compare_all(&rig["file"].to_string(), &found, &rig, &mut wrong);
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn keyposes_and_features_of_the_golden_clips_from_their_bytes() {
    let Some(folder) = support::data_folder() else {
        return;
    };
    let mut wrong = Vec::new();
    for (name, golden) in support::golden_clips() {
        let found = analyse(&folder.join("cmu").join(format!("{name}.bvh")), &[]);
        compare_all(&name, &found, &golden, &mut wrong);
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
