//! The extraction against the golden values of an independent implementation.

mod support;

use motion::hodrick_prescott::low_pass;
use motion::keypose::{Extraction, Options, SelectionRule, extract};
use serde_json::Value;
use support::{assert_close, golden_clips, indices, numbers};

fn rate_hz(clip: &Value) -> f64 {
    clip["frame_rate_hz"].as_f64().expect("a rate")
}

fn first_frame(clip: &Value) -> usize {
    clip["speed_first_frame"].as_u64().expect("a frame") as usize
}

fn extraction(clip: &Value, selection: SelectionRule) -> Extraction {
    let options = Options {
        selection,
        ..Options::default()
    };
    extract(&numbers(&clip["speed"]), rate_hz(clip), &options).expect("valid options")
}

#[test]
fn filtered_speed_agrees() {
    for (name, clip) in golden_clips() {
        let speed = numbers(&clip["speed"]);
        for (cutoff_hz, golden) in clip["hp_of_speed"].as_object().expect("cut-offs") {
            let cutoff_hz: f64 = cutoff_hz.parse().expect("a cut-off");
            let tolerance = if cutoff_hz < 0.2 { 1e-8 } else { 1e-9 };
            let found = low_pass(&speed, cutoff_hz, rate_hz(&clip));
            assert_close(
                &format!("{name} {cutoff_hz} Hz"),
                &found,
                &numbers(golden),
                tolerance,
            );
        }
    }
}

#[test]
fn candidates_and_traces_agree() {
    for (name, clip) in golden_clips() {
        let found = extraction(&clip, SelectionRule::Automatic);
        let file_frame = |frame: &usize| frame + first_frame(&clip);
        let candidates: Vec<usize> = found.candidates.iter().map(file_frame).collect();
        assert_eq!(
            candidates,
            indices(&clip["candidates"]),
            "{name}: candidates"
        );
        assert_close(&name, &found.scales_hz, &numbers(&clip["scales_hz"]), 1e-8);
        for (scale, golden) in clip["trace"].as_object().expect("scales") {
            let scale: usize = scale.parse().expect("the index of a scale");
            let at_scale = |candidate: usize| {
                let frame = found.traces.of(candidate).0.get(scale)?;
                Some(vec![file_frame(frame), candidate])
            };
            let found: Vec<_> = (0..candidates.len()).filter_map(at_scale).collect();
            let golden: Vec<_> = golden
                .as_array()
                .expect("pairs")
                .iter()
                .map(indices)
                .collect();
            assert_eq!(found, golden, "{name}: trace at scale {scale}");
        }
    }
}

#[test]
fn intensity_agrees() {
    for (name, clip) in golden_clips() {
        let found = extraction(&clip, SelectionRule::Automatic);
        assert_close(&name, &found.intensity, &numbers(&clip["intensity"]), 1e-7);
    }
}

#[test]
fn keyposes_agree() {
    for (name, clip) in golden_clips() {
        let rules = [
            ("keyposes", SelectionRule::Automatic),
            ("keyposes_literal", SelectionRule::Literal),
        ];
        for (field, rule) in rules {
            let found = extraction(&clip, rule).keyposes();
            let found: Vec<usize> = found
                .iter()
                .map(|frame| frame + first_frame(&clip))
                .collect();
            assert_eq!(found, indices(&clip[field]), "{name}: {field}");
        }
    }
}

#[test]
fn the_paper_s_example_is_as_published() {
    for (name, clip) in golden_clips() {
        if name == "07_01" {
            let found = extraction(&clip, SelectionRule::Automatic);
            assert_eq!(found.candidates.len(), 14);
            assert_eq!(found.intensity.iter().filter(|&&u| u == 0.0).count(), 5);
            assert_eq!(found.selection.clusters, 2);
            let test = found.selection.analysis_of_variance.expect("a test");
            assert_eq!((test.df_between, test.df_within), (1, 12));
            assert!(test.p < 0.01);
            assert!(found.sureness.is_sure());
        }
    }
}
