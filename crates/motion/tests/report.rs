//! Reports: the exact text of a small motion.

use motion::analysis::{Decisions, analyse};
use motion::bvh;
use motion::keypose::Options;
use motion::report::{Subject, Table, csv, json_lines};

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
        json_lines(subject, Table::Keyposes, &[])
    });
    assert_eq!(line.matches('\n').count(), 1);
    let value: serde_json::Value = serde_json::from_str(&line).expect("JSON");
    let members = [
        "file",
        "performer",
        "sha256",
        "version",
        "parameters",
        "frames",
        "frame_time_s",
        "frame_rate_hz",
        "frame_rate_source",
        "leading_rest_frames",
        "leading_rest_reason",
        "up",
        "up_source",
        "ground_height",
        "ground_source",
        "unit",
        "unit_source",
        "body",
        "notes",
        "candidates",
        "keyposes",
        "clusters",
        "anova",
        "sureness",
        "cut",
        "maximum_speed",
        "unanalysed",
        "feature",
        "thumbnail_frame",
        "trail_joints",
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
    let line = with_subject(&text, "short.bvh", |subject| {
        json_lines(subject, Table::Keyposes, &[])
    });
    let tail = "\"candidates\":[],\"keyposes\":[],\"clusters\":0,\"anova\":null,\"sureness\":null,\
        \"cut\":null,\"maximum_speed\":null,\"unanalysed\":{\"line\":null,\"column\":null,\"frame\":null,\"kind\":\"too-short\",\
        \"message\":\"Too few frames to find keyposes: 1.\"},\"feature\":null,\
        \"thumbnail_frame\":0,\"trail_joints\":[]}\n";
    assert!(line.ends_with(tail), "{line}");
    assert_eq!(
        with_subject(&text, "short.bvh", |subject| csv::rows(
            subject,
            Table::Keyposes
        )),
        ""
    );
}

/// The lines of JSON of a table, the header of its CSV, and its rows without line ends.
fn both_forms(table: Table) -> (serde_json::Value, Vec<String>, Vec<String>) {
    with_subject(&stick(), "a,b.bvh", |subject| {
        let line = json_lines(subject, table, &[]);
        let header = csv::header(table).trim_end().split(',').map(str::to_owned);
        let rows = csv::rows(subject, table);
        assert!(rows.ends_with("\r\n"));
        (
            serde_json::from_str(&line).expect("JSON"),
            header.collect(),
            rows.split_terminator("\r\n").map(str::to_owned).collect(),
        )
    })
}

/// A value of JSON as a field of a table.
fn field(value: &serde_json::Value) -> String {
    match value {
        serde_json::Value::Null => String::new(),
        serde_json::Value::String(text) => text.clone(),
        other => other.to_string(),
    }
}

/// A number as serde_json reads and writes it, which is not always exact in the last digit.
fn read_again(text: &str) -> String {
    serde_json::from_str(text).map_or_else(|_| text.to_owned(), |value| field(&value))
}

const PARAMETERS: &str = "low_pass_hz=10 trend_hz=0.5 scale_max_hz=8 scale_min_hz=0.2 \
    scale_ratio=0.95 depth_floor=1e-6 mojena_k=2.75 selection=automatic";

#[test]
fn tables_and_lines_of_moments_agree() {
    for (table, member) in [
        (Table::Keyposes, "keyposes"),
        (Table::Candidates, "candidates"),
    ] {
        let (line, header, rows) = both_forms(table);
        assert_eq!(line["version"], env!("CARGO_PKG_VERSION"));
        assert_eq!(line["parameters"]["scale_ratio"], 0.95);
        assert_eq!(line["parameters"]["selection"], "automatic");
        let moments = line[member].as_array().expect("a list");
        assert!(!moments.is_empty());
        assert_eq!(rows.len(), moments.len());
        for (index, (moment, row)) in moments.iter().zip(&rows).enumerate() {
            let row = row.strip_prefix("\"a,b.bvh\",").expect("the file first");
            let found: Vec<&str> = row.split(',').collect();
            assert_eq!(found.len(), header.len() - 1);
            for (name, found) in header[1..].iter().zip(found) {
                let expected = match name.as_str() {
                    "performer" => "0".to_owned(),
                    "number" => (index + 1).to_string(),
                    "sha256" => "00ff".to_owned(),
                    "version" => env!("CARGO_PKG_VERSION").to_owned(),
                    "parameters" => PARAMETERS.to_owned(),
                    // Not a human body: nothing is said of its parts.
                    "posture" => String::new(),
                    name if name.ends_with("_percent") => String::new(),
                    name => field(&moment[name]),
                };
                assert_eq!(read_again(found), expected, "{name}");
            }
        }
    }
}

#[test]
fn ranks_count_from_the_most_intense() {
    let (line, ..) = both_forms(Table::Candidates);
    let mut moments: Vec<(u64, f64)> = line["candidates"]
        .as_array()
        .expect("a list")
        .iter()
        .map(|one| {
            (
                one["rank"].as_u64().unwrap(),
                one["intensity"].as_f64().unwrap(),
            )
        })
        .collect();
    moments.sort_by_key(|(rank, _)| *rank);
    let ranks: Vec<u64> = moments.iter().map(|(rank, _)| *rank).collect();
    assert_eq!(ranks, (1..=moments.len() as u64).collect::<Vec<_>>());
    assert!(moments.windows(2).all(|pair| pair[0].1 >= pair[1].1));
}

#[test]
fn tables_and_lines_of_traces_agree() {
    let (line, _, rows) = both_forms(Table::Traces);
    let traces = line["traces"].as_array().expect("a list");
    let expected = traces.iter().enumerate().flat_map(|(index, trace)| {
        let number = index + 1;
        let count = trace["u"].as_array().expect("a list").len();
        let scales_hz = &line["scales_hz"];
        (0..count).map(move |scale| {
            let lists = [scales_hz, &trace["frames"], &trace["places"], &trace["u"]];
            let fields = lists.map(|list| field(&list[scale])).join(",");
            format!("\"a,b.bvh\",0,{number},{fields}")
        })
    });
    let mut count = 0;
    for (row, expected) in rows.iter().zip(expected) {
        let mut fields: Vec<String> = row.rsplitn(5, ',').map(read_again).collect();
        fields.reverse();
        assert_eq!(fields.join(","), expected);
        count += 1;
    }
    assert!(count > 0);
    assert_eq!(rows.len(), count);
}

#[test]
fn the_u_of_a_trace_add_up_to_its_intensity() {
    let (line, ..) = both_forms(Table::Traces);
    let (candidates, ..) = both_forms(Table::Candidates);
    let traces = line["traces"].as_array().expect("a list");
    for (trace, candidate) in traces
        .iter()
        .zip(candidates["candidates"].as_array().unwrap())
    {
        assert_eq!(trace["candidate"], candidate["frame"]);
        let u = trace["u"].as_array().unwrap().iter();
        let sum: f64 = u.map(|u| u.as_f64().unwrap()).sum();
        assert!((candidate["intensity"].as_f64().unwrap() - sum).abs() < 1e-12);
    }
}
