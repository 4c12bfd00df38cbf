//! Why a keypose is one: body parts, traces and trails of real motions against plain recomputation.

mod support;

use motion::analysis::{Decisions, PerformerAnalysis, analyse};
use motion::body::{self, BodyPart, PRINCIPAL_JOINTS, Role, TableBuilder};
use motion::bvh;
use motion::clip::Clip;
use motion::hodrick_prescott::low_pass;
use motion::keypose::Options;
use motion::track::PelvisTrack;

/// A clip, its analysis, and its track made anew.
fn studied(name: &str) -> Option<(Clip, PerformerAnalysis, PelvisTrack)> {
    let path = support::data_folder()?.join("cmu").join(name);
    let clip = bvh::parse(&std::fs::read(path).expect("a readable file")).expect("a clip");
    let analysis = analyse(&clip, &Decisions::default(), &Options::default()).expect("settings");
    let body = body::find(&clip, 0, &[]);
    let mut builder = TableBuilder::new(&clip, 0, &body);
    builder.step(clip.frames);
    let track = support::analysed(&clip, &body, builder.finish()).track;
    let performer = analysis.performers.into_iter().next().expect("a performer");
    Some((clip, performer, track))
}

fn column(track: &PelvisTrack, column: usize) -> Vec<f64> {
    let width = 3 * track.joint_count;
    let values = track.coordinates.iter().skip(column).step_by(width);
    values.copied().collect()
}

/// Percent by the formula, frame by frame; `columns` are the filtered ones.
fn percent(columns: &[Vec<f64>], part: BodyPart, frame: usize, rate_hz: f64) -> f64 {
    let joints = (0..PRINCIPAL_JOINTS).filter(|joint| BodyPart::OF_PRINCIPAL[*joint] == part);
    let joints: Vec<usize> = joints.collect();
    let speed = |n: usize| {
        let axes = joints.iter().flat_map(|joint| 3 * joint..3 * joint + 3);
        let steps = axes.map(|axis| columns[axis][n + 1] - columns[axis][n]);
        rate_hz * steps.map(|step| step * step).sum::<f64>().sqrt()
    };
    let frames = 0..columns[0].len() - 1;
    let near = frames.filter(|n| n.abs_diff(frame) as f64 / rate_hz <= 0.5 + 1e-4);
    let around: Vec<f64> = near.map(speed).collect();
    100.0 * (speed(frame) / (around.iter().sum::<f64>() / around.len() as f64) - 1.0)
}

#[test]
fn body_parts_are_those_of_the_filtered_coordinates() {
    for name in ["07_01.bvh", "05_08.bvh"] {
        let Some((clip, found, track)) = studied(name) else {
            return;
        };
        let rate_hz = clip.frame_rate_hz();
        let columns: Vec<Vec<f64>> = (0..3 * PRINCIPAL_JOINTS)
            .map(|index| low_pass(&column(&track, index), 10.0, rate_hz))
            .collect();
        let keyposes = found.keyposes.expect("keyposes");
        let frames = keyposes.extraction.keyposes();
        assert_eq!(keyposes.part_changes.len(), frames.len());
        for (frame, change) in frames.iter().zip(&keyposes.part_changes) {
            for part in BodyPart::ALL {
                let expected = percent(&columns, part, *frame, rate_hz);
                let found = change[part.index()].expect("a speed");
                assert!(
                    (found - expected).abs() < 1e-8,
                    "{name} {frame} {}",
                    part.name()
                );
            }
        }
    }
}

#[test]
fn a_trace_lies_within_half_a_frame_of_its_frames() {
    let Some((_, found, _)) = studied("05_08.bvh") else {
        return;
    };
    let traces = found.keyposes.expect("keyposes").extraction.traces;
    let pairs = traces.places.iter().zip(&traces.frames);
    let off: Vec<f64> = pairs.map(|(place, frame)| place - *frame as f64).collect();
    assert!(off.iter().all(|off| off.abs() <= 0.5));
    let between = off.iter().filter(|off| **off != 0.0).count();
    assert!(between * 10 > off.len() * 9, "{between} of {}", off.len());
}

#[test]
fn trails_are_of_the_hand_and_foot_that_travel_farthest() {
    for name in ["05_08.bvh", "07_01.bvh", "09_01.bvh"] {
        let Some((_, found, track)) = studied(name) else {
            return;
        };
        let length = |role: Role| {
            let places = (0..track.frames()).map(|frame| {
                <[f64; 3]>::try_from(&track.frame(frame)[3 * role.index()..][..3]).unwrap()
            });
            let places: Vec<[f64; 3]> = places.collect();
            let step = |pair: &[[f64; 3]]| {
                let steps = (0..3).map(|axis| pair[1][axis] - pair[0][axis]);
                steps.map(|step| step * step).sum::<f64>().sqrt()
            };
            places.windows(2).map(step).sum::<f64>()
        };
        let longest = |roles: [Role; 2]| match length(roles[1]) > length(roles[0]) {
            true => found.survey.body.joint(roles[1]).unwrap(),
            false => found.survey.body.joint(roles[0]).unwrap(),
        };
        let expected = [
            longest([Role::LeftWrist, Role::RightWrist]),
            longest([Role::LeftAnkle, Role::RightAnkle]),
        ];
        assert_eq!(found.trail_joints, expected, "{name}");
    }
}
