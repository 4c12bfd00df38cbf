//! Reports: the exact text of a small motion.

use motion::analysis::{Decisions, analyse};
use motion::bvh;
use motion::keypose::Options;
use motion::report::{Subject, csv, json_lines};

fn stick() -> String {
    let rows: String = (0..80)
        .map(|frame| format!("0 0 0 {} 0 0\n", frame * frame % 97 + frame % 7))
        .collect();
    format!(
        "HIERARCHY\nROOT a \"b\"\n{{\nOFFSET 0 0 0\nCHANNELS 3 Xposition Yposition Zposition\n\
         JOINT c\n{{\nOFFSET 0 1 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n\
         JOINT d\n{{\nOFFSET 0 1 0\nCHANNELS 0\n\
         End Site\n{{\nOFFSET 0 1 0\n}}\n}}\n}}\n}}\nMOTION\nFrames: 80\nFrame Time: 0.0625\n{rows}"
    )
}

fn with_subject<T>(text: &str, file: &str, of: impl Fn(&Subject) -> T) -> T {
    let clip = bvh::parse(text.as_bytes()).expect("a clip");
    let analysis = analyse(&clip, &Decisions::default(), &Options::default()).expect("settings");
    of(&Subject {
        file,
        sha256: "00ff",
        clip: &clip,
        analysis: &analysis,
    })
}

#[test]
fn an_object_a_line_with_every_member() {
    let line = with_subject(&stick(), "dir/\"x\".bvh", |subject| {
        json_lines(subject, &[])
    });
    assert_eq!(line.matches('\n').count(), 1);
    let value: serde_json::Value = serde_json::from_str(&line).expect("JSON");
    let members = [
        "file",
        "performer",
        "sha256",
        "frames",
        "frame_time_s",
        "frame_rate_hz",
        "frame_rate_source",
        "leading_rest_frames",
        "leading_rest_reason",
        "up",
        "up_source",
        "ground_height",
        "unit",
        "body",
        "notes",
        "candidates",
        "keyposes",
        "clusters",
        "anova",
        "sureness",
        "unanalysed",
        "feature",
    ];
    let object = value.as_object().expect("an object");
    assert_eq!(object.len(), members.len());
    for member in members {
        assert!(object.contains_key(member), "{member}");
    }
    assert_eq!(value["file"], "dir/\"x\".bvh");
    assert_eq!(value["frame_rate_hz"], 16.0);
    assert_eq!(value["body"]["kind"], "other");
    assert_eq!(value["body"]["pelvis"], "a \"b\"");
    assert_eq!(value["notes"][0]["kind"], "not-human");
}

#[test]
fn a_motion_too_short_is_a_line_that_says_so() {
    let text = stick();
    let (head, _) = text.split_once("Frames").expect("frames");
    let text = format!("{head}Frames: 1\nFrame Time: 0.0625\n0 0 0 0 0 0\n");
    let line = with_subject(&text, "short.bvh", |subject| json_lines(subject, &[]));
    let tail = "\"candidates\":[],\"keyposes\":[],\"clusters\":0,\"anova\":null,\"sureness\":null,\
        \"unanalysed\":{\"line\":null,\"column\":null,\"frame\":null,\"kind\":\"too-short\",\
        \"message\":\"Too few frames to find keyposes: 1.\"},\"feature\":null}\n";
    assert!(line.ends_with(tail), "{line}");
    assert_eq!(with_subject(&text, "short.bvh", csv::rows), "");
}

#[test]
fn the_table_and_the_lines_agree() {
    let line = with_subject(&stick(), "a,b.bvh", |subject| json_lines(subject, &[]));
    let value: serde_json::Value = serde_json::from_str(&line).expect("JSON");
    let rows: String = value["keyposes"]
        .as_array()
        .expect("a list")
        .iter()
        .enumerate()
        .map(|(index, keypose)| {
            let order = index + 1;
            let text = |member: &str| keypose[member].to_string();
            let (frame, time_s) = (
                text("frame"),
                keypose["frame"].as_f64().expect("a frame") / 16.0,
            );
            format!(
                "\"a,b.bvh\",0,{order},{frame},{time_s},{}\r\n",
                text("intensity")
            )
        })
        .collect();
    assert!(!rows.is_empty());
    assert_eq!(with_subject(&stick(), "a,b.bvh", csv::rows), rows);
}
