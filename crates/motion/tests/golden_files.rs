//! From the bytes of a file to its speed, keyposes and feature, against golden values, and against
//! marks on walks.

mod support;

use std::fs;
use std::path::Path;

use motion::body::{self, Role, TableBuilder};
use motion::clip::Clip;
use motion::feature::posture_variation;
use motion::hodrick_prescott::low_pass;
use motion::keypose::evaluation::{Mark, Span, evaluate};
use motion::keypose::{Extraction, Options, SelectionRule, extract};
use motion::speed::motion_speed;
use serde_json::Value;
use support::{assert_close, data_folder, golden_clips, indices, numbers};

struct Found {
    analysed: support::Analysed,
    rate_hz: f64,
    speed: Vec<f64>,
}

impl Found {
    fn extraction(&self, selection: SelectionRule) -> Extraction {
        let options = Options {
            selection,
            ..Options::default()
        };
        extract(&self.speed, self.rate_hz, &options).expect("valid options")
    }

    fn file_frames(&self, frames: &[usize]) -> Vec<usize> {
        frames
            .iter()
            .map(|frame| frame + self.analysed.track.first_frame)
            .collect()
    }
}

fn analyse(clip: &Clip, overrides: &[(Role, usize)]) -> Found {
    let body = body::find(clip, 0, overrides);
    let mut builder = TableBuilder::new(clip, 0, &body);
    while !builder.step(1000) {}
    let analysed = support::analysed(clip, &body, builder.finish());
    let rate_hz = clip.frame_rate_hz();
    let speed = motion_speed(&analysed.track, rate_hz, Options::default().low_pass_hz).values;
    Found {
        analysed,
        rate_hz,
        speed,
    }
}

fn read(path: &Path) -> Clip {
    motion::bvh::parse(&fs::read(path).expect("a readable file")).expect("a motion")
}

/// The clips of the golden values, each found again from its file.
fn golden_files() -> Vec<(String, Found, Value)> {
    let Some(folder) = data_folder() else {
        return Vec::new();
    };
    let found = |name: &str| analyse(&read(&folder.join(format!("cmu/{name}.bvh"))), &[]);
    golden_clips()
        .into_iter()
        .map(|(name, golden)| (name.clone(), found(&name), golden))
        .collect()
}

#[test]
fn speed_and_filtered_speed_agree() {
    for (name, found, golden) in golden_files() {
        assert!((found.rate_hz - golden["frame_rate_hz"].as_f64().expect("a rate")).abs() < 1e-9);
        let first = found.analysed.track.first_frame as u64;
        assert_eq!(Some(first), golden["speed_first_frame"].as_u64(), "{name}");
        assert_close(&name, &found.speed, &numbers(&golden["speed"]), 1e-9);
        for (cutoff_hz, golden) in golden["hp_of_speed"].as_object().expect("cut-offs") {
            let cutoff_hz: f64 = cutoff_hz.parse().expect("a cut-off");
            let tolerance = if cutoff_hz < 0.2 { 1e-8 } else { 1e-9 };
            let filtered = low_pass(&found.speed, cutoff_hz, found.rate_hz);
            assert_close(
                &format!("{name} {cutoff_hz} Hz"),
                &filtered,
                &numbers(golden),
                tolerance,
            );
        }
    }
}

#[test]
fn features_agree() {
    for (name, found, golden) in golden_files() {
        let feature = posture_variation(&found.analysed.track);
        assert_close(&name, &feature, &numbers(&golden["feature"]), 1e-9);
    }
}

#[test]
fn candidates_intensity_and_keyposes_agree() {
    for (name, found, golden) in golden_files() {
        let extraction = found.extraction(SelectionRule::Automatic);
        let candidates = found.file_frames(&extraction.candidates);
        assert_eq!(candidates, indices(&golden["candidates"]), "{name}");
        assert_close(
            &name,
            &extraction.intensity,
            &numbers(&golden["intensity"]),
            1e-7,
        );
        let keyposes = found.file_frames(&extraction.keyposes());
        assert_eq!(keyposes, indices(&golden["keyposes"]), "{name}");
        let literal = found.extraction(SelectionRule::Literal).keyposes();
        assert_eq!(
            found.file_frames(&literal),
            indices(&golden["keyposes_literal"]),
            "{name}"
        );
    }
}

/// The roles and joints that a rig's answers name.
fn named_joints(clip: &Clip, rig: &Value) -> Vec<(Role, usize)> {
    let labels = clip.performers[0].skeleton.labels();
    let joint = |role: &Role| {
        let name = rig["body"][role.name()].as_str()?;
        Some((*role, labels.iter().position(|label| label == name)?))
    };
    Role::ALL.iter().filter_map(joint).collect()
}

#[test]
fn rigs_agree_with_the_joints_that_are_named() {
    let Some(folder) = data_folder() else {
        return;
    };
    let text = fs::read_to_string(folder.join("rigs.golden.json")).expect("the answers");
    let rigs: Vec<Value> = serde_json::from_str(&text).expect("JSON");
    // Postures without a motion have no keyposes.
    for rig in rigs
        .iter()
        .filter(|rig| rig["kind"] == "human" && rig["keyposes"].is_array())
    {
        let name = rig["file"].as_str().expect("a name");
        let clip = read(&folder.join("rigs").join(name));
        let found = analyse(&clip, &named_joints(&clip, rig));
        let extraction = found.extraction(SelectionRule::Automatic);
        let candidates = found.file_frames(&extraction.candidates);
        assert_eq!(candidates, indices(&rig["candidates"]), "{name}");
        let keyposes = found.file_frames(&extraction.keyposes());
        assert_eq!(keyposes, indices(&rig["keyposes"]), "{name}");
        // These answers are written with nine digits.
        assert_close(
            name,
            &extraction.intensity,
            &numbers(&rig["intensity"]),
            1e-7,
        );
        let feature = posture_variation(&found.analysed.track);
        assert_close(name, &feature, &numbers(&rig["feature"]), 1e-8);
    }
}

#[test]
fn keyposes_of_walks_are_their_heel_strikes() {
    let Some(folder) = data_folder() else {
        return;
    };
    let mut scores = Vec::new();
    for entry in fs::read_dir(folder.join("marks")).expect("a folder of marks") {
        let text = fs::read_to_string(entry.expect("an entry").path()).expect("a readable file");
        let walk: Value = serde_json::from_str(&text).expect("JSON");
        let file = walk["file"].as_str().expect("a name");
        let found = analyse(&read(&folder.join("cmu").join(file)), &[]);
        let keyposes = found.extraction(SelectionRule::Automatic).keyposes();
        let marks: Vec<Mark> = indices(&walk["frames"]).into_iter().map(Mark::at).collect();
        scores.push(evaluate(&found.file_frames(&keyposes), &marks, Span::Clip).f);
    }
    assert_eq!(scores.len(), 12);
    let mean = scores.iter().sum::<f64>() / 12.0;
    assert!(mean >= 0.96, "mean F {mean}: {scores:?}");
}
