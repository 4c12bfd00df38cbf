//! The analysis of whole clips: what it finds, that its steps do not matter, and that a changed
//! setting gives what a fresh analysis gives.

mod support;

use motion::analysis::{Analyser, Analysis, Decisions, analyse};
use motion::bvh;
use motion::clip::Clip;
use motion::keypose::{Options, SelectionRule};
use motion::world::Up;

fn finished(analyser: &mut Analyser, clip: &Clip) -> Analysis {
    let mut last = 0.0;
    loop {
        let done = analyser.step(clip);
        assert!(done >= last, "progress went back from {last} to {done}");
        last = done;
        if done >= 1.0 {
            return analyser.analysis();
        }
    }
}

fn cmu(name: &str) -> Option<Clip> {
    let path = support::data_folder()?
        .join("cmu")
        .join(format!("{name}.bvh"));
    let bytes = std::fs::read(path).expect("a readable file");
    Some(bvh::parse(&bytes).expect("a clip"))
}

#[test]
fn golden_clips_have_their_keyposes() {
    for (name, golden) in support::golden_clips() {
        let Some(clip) = cmu(&name) else { return };
        for (selection, field) in [
            (SelectionRule::Automatic, "keyposes"),
            (SelectionRule::Literal, "keyposes_literal"),
        ] {
            let options = Options {
                selection,
                ..Options::default()
            };
            let analysis = analyse(&clip, &Decisions::default(), &options).unwrap();
            let performer = &analysis.performers[0];
            let found = performer.keyposes.as_ref().expect("keyposes").keyposes();
            assert_eq!(serde_json::json!(found), golden[field], "{name} {field}");
            let left_out = performer.leading_rest.frames;
            assert_eq!(
                serde_json::json!(left_out),
                golden["leading_rest_frames"],
                "{name}"
            );
        }
    }
}

#[test]
fn a_changed_setting_gives_what_a_fresh_analysis_gives() {
    let Some(clip) = cmu("07_01") else { return };
    let plain = (Decisions::default(), Options::default());
    let settings = [
        (
            Decisions {
                frame_rate_hz: Some(60.0),
                ..plain.0
            },
            plain.1,
        ),
        (
            Decisions {
                leading_rest_frames: Some(0),
                ..plain.0
            },
            plain.1,
        ),
        (
            Decisions {
                up: Up::from_name("+Z"),
                ..plain.0
            },
            plain.1,
        ),
        (
            plain.0,
            Options {
                low_pass_hz: 6.0,
                ..plain.1
            },
        ),
        (
            plain.0,
            Options {
                scale_max_hz: 6.0,
                ..plain.1
            },
        ),
        (
            plain.0,
            Options {
                trend_hz: 1.0,
                ..plain.1
            },
        ),
        (
            plain.0,
            Options {
                selection: SelectionRule::EvenSplit,
                ..plain.1
            },
        ),
        plain,
    ];
    let mut analyser = Analyser::new();
    for (index, (decisions, options)) in settings.iter().enumerate() {
        analyser.begin(&clip, decisions, options).unwrap();
        let again = finished(&mut analyser, &clip);
        assert_eq!(
            again,
            analyse(&clip, decisions, options).unwrap(),
            "setting {index}"
        );
        if index % 2 == 0 {
            analyser.drop_motion();
        }
    }
}

#[test]
fn settings_that_cannot_be_are_refused() {
    let clip = bvh::parse(STICK.as_bytes()).unwrap();
    let decisions = Decisions {
        frame_rate_hz: Some(0.0),
        ..Decisions::default()
    };
    let error = analyse(&clip, &decisions, &Options::default()).unwrap_err();
    let expected = "frame_rate_hz is 0; expected a rate from 0.01 to 100000 frames per second";
    assert_eq!(error.to_string(), expected);
    let options = Options {
        scale_ratio: 2.0,
        ..Options::default()
    };
    let error = analyse(&clip, &Decisions::default(), &options).unwrap_err();
    assert_eq!(
        error.to_string(),
        "scale_ratio is 2; expected a number above 0 and below 1"
    );
}

const STICK: &str = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 3 Xposition Yposition Zposition\n\
    End Site\n{\nOFFSET 0 1 0\n}\n}\nMOTION\nFrames: 2\nFrame Time: 0.01\n0 0 0\n1 0 0\n";

#[test]
fn a_motion_too_short_says_why() {
    for rows in 0..6 {
        let (head, _) = STICK.split_once("Frames").unwrap();
        let body: String = (0..rows).map(|n| format!("{n} 0 0\n")).collect();
        let text = format!("{head}Frames: {rows}\nFrame Time: 0.01\n{body}");
        let clip = bvh::parse(text.as_bytes()).unwrap();
        let analysis = analyse(&clip, &Decisions::default(), &Options::default()).unwrap();
        let kind = analysis.performers[0]
            .keyposes
            .as_ref()
            .err()
            .map(|note| note.kind.name());
        let expected = [
            Some("no-motion"),
            Some("too-short"),
            Some("too-short"),
            Some("too-short"),
            None,
            None,
        ];
        assert_eq!(kind, expected[rows], "{rows} rows");
    }
}

#[test]
fn any_number_of_leading_frames_is_taken() {
    let clip = bvh::parse(STICK.as_bytes()).unwrap();
    let decisions = Decisions {
        leading_rest_frames: Some(usize::MAX),
        ..Decisions::default()
    };
    let analysis = analyse(&clip, &decisions, &Options::default()).unwrap();
    assert_eq!(analysis.performers[0].leading_rest.frames, 2);
    assert!(analysis.performers[0].keyposes.is_err());
}
