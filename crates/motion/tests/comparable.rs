//! What a comparison takes of a clip, on real recordings.

mod support;

use std::fs;

use motion::analysis::{Decisions, PerformerAnalysis, analyse};
use motion::feature::{ComparableFeature, posture_variation};
use motion::keypose::Options;
use support::{data_folder, golden_clips};

fn performer(bytes: &[u8]) -> PerformerAnalysis {
    let clip = motion::bvh::parse(bytes).expect("a motion");
    let analysis = analyse(&clip, &Decisions::default(), &Options::default()).expect("an analysis");
    analysis.performers.into_iter().next().expect("a performer")
}

fn clips() -> Vec<(String, PerformerAnalysis, ComparableFeature)> {
    let Some(folder) = data_folder() else {
        return Vec::new();
    };
    let read = |(name, _)| {
        let bytes = fs::read(folder.join(format!("cmu/{name}.bvh"))).expect("a readable file");
        let found = performer(&bytes);
        let comparable = found.survey.comparable.clone().expect("a human body");
        (name, found, comparable)
    };
    golden_clips().into_iter().map(read).collect()
}

#[test]
fn the_recorded_feature_is_that_of_the_track() {
    for (name, found, comparable) in clips() {
        assert_eq!(Some(comparable.recorded), found.survey.feature, "{name}");
        let path = data_folder().expect("data").join(format!("cmu/{name}.bvh"));
        let clip = motion::bvh::parse(&fs::read(path).expect("a file")).expect("a motion");
        let mut builder = motion::body::TableBuilder::new(&clip, 0, &found.survey.body);
        builder.step(clip.frames);
        let track = support::analysed(&clip, &found.survey.body, builder.finish()).track;
        assert_eq!(comparable.recorded, posture_variation(&track), "{name}");
    }
}

#[test]
fn joints_sum_up_to_both_features() {
    for (name, _, found) in clips() {
        let pairs = [
            (found.recorded, found.recorded_by_joint),
            (found.across_rigs, found.across_rigs_by_joint),
        ];
        for (feature, by_joint) in pairs {
            for (index, value) in feature.iter().enumerate() {
                let sum: f64 = by_joint.iter().map(|part| part[index]).sum();
                assert!((sum - value).abs() < 1e-12, "{name}: {sum}, not {value}");
            }
        }
    }
}

#[test]
fn a_body_that_is_not_human_is_not_compared() {
    let Some(folder) = data_folder() else {
        return;
    };
    let text = fs::read_to_string(folder.join("rigs.golden.json")).expect("the answers");
    let rigs: Vec<serde_json::Value> = serde_json::from_str(&text).expect("JSON");
    for rig in rigs.iter().filter(|rig| rig["kind"] == "animal") {
        let path = folder
            .join("rigs")
            .join(rig["file"].as_str().expect("a name"));
        let found = performer(&fs::read(path).expect("a readable file"));
        assert_eq!(
            (found.survey.feature, found.survey.comparable),
            (None, None)
        );
    }
}
