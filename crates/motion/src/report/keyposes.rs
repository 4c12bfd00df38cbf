//! The object of one file and performer: what was found in it, and its keyposes.

use super::Subject;
use super::body::body;
use super::json::Json;
use crate::analysis::{KeyposeAnalysis, PerformerAnalysis};
use crate::keypose::evaluation::Evaluation;
use crate::note::Note;

/// The object of one performer (from 0), as `docs/formats.md` describes it.
pub fn json_line(subject: &Subject, performer: usize, evaluation: Option<&Evaluation>) -> Json {
    let Some(found) = subject.analysis.performers.get(performer) else {
        return Json::Null;
    };
    let labels = subject.clip.performers[performer].skeleton.labels();
    let mut members = file_members(subject, performer);
    members.extend(motion_members(found));
    members.push(("body", body(found, &labels)));
    members.push((
        "notes",
        Json::list(subject.clip.notes.iter().chain(&found.notes).map(note)),
    ));
    members.extend(keypose_members(subject, found));
    members.push(("feature", found.feature.map(Json::list).into()));
    if let Some(evaluation) = evaluation {
        members.push(("evaluation", evaluation_object(evaluation)));
    }
    Json::Object(members)
}

type Members = Vec<(&'static str, Json)>;

fn file_members(subject: &Subject, performer: usize) -> Members {
    let analysis = subject.analysis;
    vec![
        ("file", subject.file.into()),
        ("performer", performer.into()),
        ("sha256", subject.sha256.into()),
        ("frames", subject.clip.frames.into()),
        ("frame_time_s", analysis.frame_time_s.into()),
        ("frame_rate_hz", (1.0 / analysis.frame_time_s).into()),
        (
            "frame_rate_source",
            analysis.frame_time_source.name().into(),
        ),
    ]
}

fn motion_members(found: &PerformerAnalysis) -> Members {
    vec![
        ("leading_rest_frames", found.leading_rest.frames.into()),
        (
            "leading_rest_reason",
            super::reason_name(found.leading_rest).into(),
        ),
        ("up", found.up.0.name().into()),
        ("up_source", found.up.1.name().into()),
        ("ground_height", found.ground_height.into()),
        ("unit", found.unit.map(|(unit, _)| unit.name()).into()),
    ]
}

fn keypose_members(subject: &Subject, found: &PerformerAnalysis) -> Members {
    let Ok(keyposes) = &found.keyposes else {
        let reason = found.keyposes.as_ref().err().map(note);
        return vec![
            ("candidates", Json::List(Vec::new())),
            ("keyposes", Json::List(Vec::new())),
            ("clusters", 0_usize.into()),
            ("anova", Json::Null),
            ("sureness", Json::Null),
            ("unanalysed", reason.into()),
        ];
    };
    let selection = &keyposes.extraction.selection;
    let anova = selection.analysis_of_variance.as_ref();
    vec![
        ("candidates", candidates(keyposes)),
        (
            "keyposes",
            keypose_list(keyposes, subject.analysis.frame_time_s),
        ),
        ("clusters", selection.clusters.into()),
        (
            "anova",
            anova
                .map(|test| Json::object([("f", test.f.into()), ("p", test.p.into())]))
                .into(),
        ),
        ("sureness", keyposes.extraction.sureness.ratio.into()),
        ("unanalysed", Json::Null),
    ]
}

fn candidates(keyposes: &KeyposeAnalysis) -> Json {
    let extraction = &keyposes.extraction;
    let pairs = extraction.candidates.iter().zip(&extraction.intensity);
    Json::list(pairs.map(|(frame, intensity)| {
        let frame = keyposes.first_frame + frame;
        Json::object([("frame", frame.into()), ("intensity", (*intensity).into())])
    }))
}

fn keypose_list(keyposes: &KeyposeAnalysis, frame_time_s: f64) -> Json {
    Json::list(keyposes.rows().map(|(frame, intensity)| {
        Json::object([
            ("frame", frame.into()),
            ("time_s", (frame as f64 * frame_time_s).into()),
            ("intensity", intensity.into()),
        ])
    }))
}

fn evaluation_object(evaluation: &Evaluation) -> Json {
    Json::object([
        ("precision", evaluation.precision.into()),
        ("recall", evaluation.recall.into()),
        ("f", evaluation.f.into()),
    ])
}

/// A note: where it is, what it is about, its sentence.
fn note(note: &Note) -> Json {
    Json::object([
        ("line", note.line.into()),
        ("column", note.column.into()),
        ("frame", note.frame.into()),
        ("kind", note.kind.name().into()),
        ("message", note.message().into()),
    ])
}
