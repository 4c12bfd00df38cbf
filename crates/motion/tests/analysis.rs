//! The analysis of whole clips: what it finds, that its steps do not matter, and that a changed
//! setting gives what a fresh analysis gives.

mod support;

use motion::analysis::{Analyser, Analysis, Decisions, JointDecision, Source, analyse, survey};
use motion::body::{self, Role};
use motion::bvh;
use motion::clip::Clip;
use motion::keypose::{Options, SelectionRule};
use motion::note::NoteKind;
use motion::world::{Unit, Up};

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
            let left_out = performer.survey.leading_rest.frames;
            assert_eq!(
                serde_json::json!(left_out),
                golden["leading_rest_frames"],
                "{name}"
            );
        }
    }
}

/// Settings of every kind, each with what it changes.
fn all_settings() -> Vec<(&'static str, Decisions, Options)> {
    let decide = |name, change: fn(&mut Decisions)| {
        let mut decisions = Decisions::default();
        change(&mut decisions);
        (name, decisions, Options::default())
    };
    let choose = |name, change: fn(&mut Options)| {
        let mut options = Options::default();
        change(&mut options);
        (name, Decisions::default(), options)
    };
    vec![
        decide("nothing", |_| ()),
        decide("rate", |one| one.frame_rate_hz = Some(60.0)),
        decide("rest", |one| one.leading_rest_frames = Some(7)),
        decide("up", |one| one.up = Up::from_name("+Z")),
        decide("unit", |one| one.unit = Some(Unit::Inch)),
        decide("joints", |one| {
            one.joints = vec![JointDecision {
                performer: 0,
                role: Role::LeftToe,
                joint: 3,
            }];
        }),
        choose("low pass", |one| one.low_pass_hz = 6.0),
        choose("trend", |one| one.trend_hz = 1.0),
        choose("finest scale", |one| one.scale_max_hz = 6.0),
        choose("coarsest scale", |one| one.scale_min_hz = 0.5),
        choose("ratio", |one| one.scale_ratio = 0.9),
        choose("selection", |one| one.selection = SelectionRule::EvenSplit),
        choose("Mojena", |one| one.mojena_k = 1.0),
    ]
}

fn clips() -> Vec<Clip> {
    let recorded = cmu("07_01");
    [person_without_sides(150)]
        .into_iter()
        .chain(recorded)
        .collect()
}

#[test]
fn a_changed_setting_gives_what_a_fresh_analysis_gives() {
    for clip in clips() {
        let settings = all_settings();
        let fresh = |(_, decisions, options): &(&str, Decisions, Options)| {
            analyse(&clip, decisions, options).unwrap()
        };
        let fresh: Vec<Analysis> = settings.iter().map(fresh).collect();
        for (first, (before, decisions, options)) in settings.iter().enumerate() {
            for (second, (after, ..)) in settings.iter().enumerate() {
                let (_, other_decisions, other_options) = &settings[second];
                let mut analyser = Analyser::new();
                analyser.begin(&clip, decisions, options).unwrap();
                finished(&mut analyser, &clip);
                // A change that is taken back in the middle of the work.
                analyser
                    .begin(&clip, other_decisions, other_options)
                    .unwrap();
                for _ in 0..(first * second) % 11 {
                    analyser.step(&clip);
                }
                analyser.begin(&clip, decisions, options).unwrap();
                let back = finished(&mut analyser, &clip);
                assert!(back == fresh[first], "{after} and back to {before}");
                if (first + second) % 3 == 0 {
                    analyser.drop_motion();
                }
                analyser
                    .begin(&clip, other_decisions, other_options)
                    .unwrap();
                let found = finished(&mut analyser, &clip);
                assert!(found == fresh[second], "{before}, then {after}");
            }
        }
    }
}

#[test]
fn a_changed_setting_repeats_only_what_depends_on_it() {
    let clip = person_without_sides(150);
    let steps = |analyser: &mut Analyser| {
        let mut steps = 1;
        while analyser.step(&clip) < 1.0 {
            steps += 1;
        }
        steps
    };
    let mut analyser = Analyser::new();
    let (plain, options) = (Decisions::default(), Options::default());
    analyser.begin(&clip, &plain, &options).unwrap();
    let whole = steps(&mut analyser);
    let again = |(_, decisions, options): &(&str, Decisions, Options)| {
        analyser.begin(&clip, decisions, options).unwrap();
        steps(&mut analyser);
        // Back to the setting whose whole is known.
        analyser.begin(&clip, &plain, &Options::default()).unwrap();
        steps(&mut analyser)
    };
    let settings = all_settings();
    let names = settings.iter().map(|(name, ..)| *name);
    let found: Vec<_> = names.zip(settings.iter().map(again)).collect();
    let few = |name| matches!(name, "up" | "unit" | "trend" | "selection" | "Mojena");
    for (name, back) in found {
        let most = match name {
            "nothing" => 1,
            name if few(name) => 10,
            // Without the poses, the speed and the trend.
            "finest scale" | "coarsest scale" | "ratio" => whole - 20,
            "low pass" | "rate" => whole - 5,
            _ => whole,
        };
        assert!(back <= most, "{name}: {back} of {whole} steps");
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
fn a_joint_that_the_clip_does_not_have_is_refused() {
    let clip = bvh::parse(STICK.as_bytes()).unwrap();
    for (performer, joint) in [(0, 2), (1, 0)] {
        let decisions = Decisions {
            joints: vec![JointDecision {
                performer,
                role: Role::Head,
                joint,
            }],
            ..Decisions::default()
        };
        let error = analyse(&clip, &decisions, &Options::default()).unwrap_err();
        assert_eq!(
            error.to_string(),
            format!(
                "joints is head = joint {joint} of performer {performer}; expected a joint of the clip"
            )
        );
    }
}

#[test]
fn a_joint_decided_by_a_person_changes_the_result_and_can_be_taken_back() {
    let Some(clip) = cmu("07_01") else { return };
    let (found, options) = (Decisions::default(), Options::default());
    let first = analyse(&clip, &found, &options).unwrap();
    let body = &first.performers[0].survey.body;
    let elbow = body.joint(Role::LeftElbow).unwrap();
    let decided = Decisions {
        joints: vec![JointDecision {
            performer: 0,
            role: Role::LeftWrist,
            joint: elbow,
        }],
        ..found.clone()
    };
    let mut analyser = Analyser::new();
    analyser.begin(&clip, &found, &options).unwrap();
    assert_eq!(finished(&mut analyser, &clip), first);
    analyser.begin(&clip, &decided, &options).unwrap();
    let changed = finished(&mut analyser, &clip);
    assert_eq!(changed, analyse(&clip, &decided, &options).unwrap());
    let wrist = changed.performers[0].survey.body.joints[Role::LeftWrist.index()];
    assert_eq!((wrist.joint, wrist.source), (elbow, body::Source::User));
    let speed = |analysis: &Analysis| {
        let keyposes = analysis.performers[0].keyposes.as_ref().unwrap();
        keyposes.speed.clone()
    };
    assert_ne!(speed(&changed), speed(&first));
    analyser.begin(&clip, &found, &options).unwrap();
    assert_eq!(finished(&mut analyser, &clip), first);
}

#[test]
fn a_joint_decided_for_one_performer_leaves_the_other_as_it_was() {
    let text = STICK.split_once("MOTION").unwrap().0;
    let rows: String = (0..30)
        .map(|n| format!("{n} 0 0 0 {} 0\n", n * n % 7))
        .collect();
    let text = format!(
        "{text}{}MOTION\nFrames: 30\nFrame Time: 0.01\n{rows}",
        &text[10..]
    );
    let clip = bvh::parse(text.as_bytes()).expect("two performers");
    let first = analyse(&clip, &Decisions::default(), &Options::default()).unwrap();
    let decisions = Decisions {
        joints: vec![JointDecision {
            performer: 1,
            role: Role::Head,
            joint: 1,
        }],
        ..Decisions::default()
    };
    let decided = analyse(&clip, &decisions, &Options::default()).unwrap();
    assert_eq!(decided.performers[0], first.performers[0]);
    assert_eq!(decided.performers[1].survey.body.joint(Role::Head), Some(1));
}

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
    assert_eq!(analysis.performers[0].survey.leading_rest.frames, 2);
    assert!(analysis.performers[0].keyposes.is_err());
}

/// A person whose hips lie in one place, under a root that is not the pelvis: no left and right.
fn person_without_sides(frames: usize) -> Clip {
    let limb = |side: &str, names: [&str; 3], offset: [&str; 4]| {
        let joint = |index: usize| {
            format!(
                "JOINT {side}{}\n{{\nOFFSET {}\nCHANNELS 3 Zrotation Xrotation Yrotation\n",
                names[index], offset[index]
            )
        };
        format!(
            "{}{}{}End Site\n{{\nOFFSET {}\n}}\n}}\n}}\n}}\n",
            joint(0),
            joint(1),
            joint(2),
            offset[3]
        )
    };
    let leg = |side| {
        limb(
            side,
            ["UpLeg", "Leg", "Foot"],
            ["0 0 0", "0 -4 0", "0 -4 0", "0 -0.5 1"],
        )
    };
    let arm = |side, out: f64| {
        let offset = [
            format!("{out} 4 0"),
            format!("{} 0 0", 3.0 * out),
            format!("{} 0 0", 2.0 * out),
            format!("{out} 0 0"),
        ];
        limb(
            side,
            ["Arm", "ForeArm", "Hand"],
            [0, 1, 2, 3].map(|index| offset[index].as_str()),
        )
    };
    let head = "JOINT Neck\n{\nOFFSET 0 5 0\nCHANNELS 0\nJOINT Head\n{\nOFFSET 0 1 0\nCHANNELS 0\n\
        End Site\n{\nOFFSET 0 1 0\n}\n}\n}\n";
    let hierarchy = format!(
        "HIERARCHY\nROOT World\n{{\nOFFSET 0 0 0\nCHANNELS 3 Xposition Yposition Zposition\n\
        JOINT Hips\n{{\nOFFSET 0 9 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n\
        {}{}JOINT Spine\n{{\nOFFSET 0 1 0\nCHANNELS 0\n{}{}{head}}}\n}}\n}}\n",
        leg("Left"),
        leg("Right"),
        arm("Left", 1.0),
        arm("Right", -1.0)
    );
    let row = |frame: usize| {
        let angle = 20.0 * libm::sin(0.2 * frame as f64);
        let joints = (0..13).map(|joint| format!("{} 0 {angle} ", angle * f64::from(joint % 3)));
        format!("0 0 {frame} {}\n", joints.collect::<String>())
    };
    let rows: String = (0..frames).map(row).collect();
    let text = format!("{hierarchy}MOTION\nFrames: {frames}\nFrame Time: 0.01\n{rows}");
    bvh::parse(text.as_bytes()).expect("a clip")
}

#[test]
fn a_body_without_left_and_right_is_followed_in_root_coordinates() {
    let clip = person_without_sides(200);
    let (decisions, options) = (Decisions::default(), Options::default());
    let fresh = analyse(&clip, &decisions, &options).unwrap();
    let performer = &fresh.performers[0];
    assert!(
        performer.survey.body.is_human(),
        "{:?}",
        performer.survey.body
    );
    assert_ne!(performer.survey.body.pelvis, 0);
    let has_note = performer
        .notes()
        .any(|note| note.kind == NoteKind::NoLeftAndRight);
    assert!(has_note, "{:?}", performer.survey.notes);
    let mut analyser = Analyser::new();
    analyser.begin(&clip, &decisions, &options).unwrap();
    assert_eq!(finished(&mut analyser, &clip), fresh);
    analyser.drop_motion();
    analyser
        .begin(
            &clip,
            &decisions,
            &Options {
                low_pass_hz: 5.0,
                ..options
            },
        )
        .unwrap();
    finished(&mut analyser, &clip);
    analyser.begin(&clip, &decisions, &options).unwrap();
    assert_eq!(finished(&mut analyser, &clip), fresh);
}

#[test]
fn a_skeleton_without_motion_stands_on_the_ground() {
    let text = "HIERARCHY\nROOT a\n{\nOFFSET 0 1 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n\
                JOINT b\n{\nOFFSET 0 -5 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n\
                End Site\n{\nOFFSET 0 -2 0\n}\n}\n}\n";
    let clip = bvh::parse(text.as_bytes()).expect("a clip");
    assert_eq!(clip.frames, 0);
    let analysis = analyse(&clip, &Decisions::default(), &Options::default()).unwrap();
    assert_eq!(analysis.performers[0].survey.ground_height, 1.0 - 5.0);
    assert_eq!(analysis.performers[0].survey.ground_source, Source::Found);
}

#[test]
fn the_ground_is_where_a_person_says() {
    let clip = bvh::parse(STICK.as_bytes()).unwrap();
    let found = analyse(&clip, &Decisions::default(), &Options::default()).unwrap();
    let decisions = Decisions {
        ground_height: Some(-12.5),
        ..Decisions::default()
    };
    let decided = analyse(&clip, &decisions, &Options::default()).unwrap();
    let mut analyser = Analyser::new();
    for (wish, expected) in [(Decisions::default(), &found), (decisions, &decided)] {
        analyser.begin(&clip, &wish, &Options::default()).unwrap();
        assert_eq!(&finished(&mut analyser, &clip), expected);
    }
    let (found, decided) = (&found.performers[0].survey, &decided.performers[0].survey);
    assert_eq!(decided.ground_height, -12.5);
    assert_eq!(decided.ground_source, Source::User);
    assert_eq!(decided.up, found.up);
    assert_eq!(decided.feature, found.feature);
}

#[test]
fn a_survey_is_what_the_analysis_finds_of_the_same() {
    for (name, _) in support::golden_clips() {
        let Some(clip) = cmu(&name) else { return };
        let analysis = analyse(&clip, &Decisions::default(), &Options::default()).unwrap();
        let survey = survey(&clip, &Decisions::default()).unwrap();
        assert_eq!(
            survey.performers,
            [analysis.performers[0].survey.clone()],
            "{name}"
        );
        assert_eq!(survey.frame_time_s, analysis.frame_time_s);
    }
}

#[test]
fn an_analysis_goes_on_from_a_survey_and_a_survey_from_an_analysis() {
    let Some(clip) = cmu("05_08") else { return };
    let (decisions, options) = (Decisions::default(), Options::default());
    let expected = analyse(&clip, &decisions, &options).unwrap();
    let mut analyser = Analyser::new();
    analyser.begin(&clip, &decisions, &options).unwrap();
    let mut last = 0.0;
    while last < 1.0 {
        let done = analyser.step_survey(&clip);
        assert!(done >= last, "progress went back from {last} to {done}");
        last = done;
    }
    let (survey, track) = (analyser.survey(), analyser.track(0).cloned());
    assert_eq!(finished(&mut analyser, &clip), expected);
    // The motion is read again for its poses: the results are there, the track is not.
    analyser.drop_motion();
    assert_eq!(analyser.track(0), None);
    analyser.begin(&clip, &decisions, &options).unwrap();
    while analyser.step_survey(&clip) < 1.0 {}
    assert_eq!(analyser.survey(), survey);
    assert_eq!(analyser.track(0), track.as_ref());
    assert_eq!(analyser.analysis(), expected);
}
