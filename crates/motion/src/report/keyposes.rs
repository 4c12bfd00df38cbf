//! The object of one file and performer: what was found in it, and its keyposes.

use super::Subject;
use super::body::body;
use super::candidates;
use super::file::{self, Members};
use super::json::Json;
use crate::analysis::{KeyposeAnalysis, PerformerAnalysis};
use crate::body::BodyPart;
use crate::keypose::AnalysisOfVariance;
use crate::keypose::evaluation::Evaluation;
use crate::note::Note;
use crate::part_change::PartChange;

/// The object of one performer (from 0), as `docs/formats.md` describes it.
pub fn object(
    subject: &Subject,
    performer: usize,
    found: &PerformerAnalysis,
    evaluation: Option<&Evaluation>,
) -> Json {
    let labels = subject.clip.performers[performer].skeleton.labels();
    let mut members = file::members(subject, performer);
    members.extend(motion_members(found));
    members.push(("body", body(found, &labels)));
    members.push((
        "notes",
        Json::list(subject.clip.notes.iter().chain(found.notes()).map(note)),
    ));
    members.extend(match &found.keyposes {
        Ok(keyposes) => keypose_members(subject, keyposes),
        Err(reason) => unanalysed_members(reason),
    });
    members.push(("feature", found.survey.feature.map(Json::list).into()));
    members.extend(picture_members(found, &labels));
    if let Some(evaluation) = evaluation {
        members.push(("evaluation", evaluation_object(evaluation)));
    }
    Json::Object(members)
}

fn motion_members(found: &PerformerAnalysis) -> Members {
    vec![
        (
            "leading_rest_frames",
            found.survey.leading_rest.frames.into(),
        ),
        (
            "leading_rest_reason",
            super::reason_name(found.survey.leading_rest).into(),
        ),
        ("up", found.survey.up.0.name().into()),
        ("up_source", found.survey.up.1.name().into()),
        ("ground_height", found.survey.ground_height.into()),
        ("ground_source", found.survey.ground_source.name().into()),
        (
            "unit",
            found.survey.unit.map(|(unit, _)| unit.name()).into(),
        ),
        (
            "unit_source",
            found.survey.unit.map(|(_, source)| source.name()).into(),
        ),
    ]
}

fn keypose_members(subject: &Subject, found: &KeyposeAnalysis) -> Members {
    let extraction = &found.extraction;
    let selection = &extraction.selection;
    let maximum = found.speed.iter().copied().fold(0.0, f64::max);
    vec![
        ("candidates", candidates::list(subject, found)),
        ("keyposes", keypose_list(subject, found)),
        ("clusters", selection.clusters.into()),
        (
            "anova",
            selection.analysis_of_variance.as_ref().map(anova).into(),
        ),
        ("sureness", extraction.sureness.ratio.into()),
        ("cut", extraction.sureness.cut().into()),
        ("maximum_speed", maximum.into()),
        ("unanalysed", Json::Null),
    ]
}

fn unanalysed_members(reason: &Note) -> Members {
    vec![
        ("candidates", Json::List(Vec::new())),
        ("keyposes", Json::List(Vec::new())),
        ("clusters", 0_usize.into()),
        ("anova", Json::Null),
        ("sureness", Json::Null),
        ("cut", Json::Null),
        ("maximum_speed", Json::Null),
        ("unanalysed", note(reason)),
    ]
}

/// Which frame and joints picture the motion.
fn picture_members(found: &PerformerAnalysis, labels: &[String]) -> Members {
    let joints = found.trail_joints.iter();
    let labels = joints.filter_map(|joint| labels.get(*joint).map(String::as_str));
    vec![
        ("thumbnail_frame", found.thumbnail_frame.into()),
        ("trail_joints", Json::list(labels)),
    ]
}

fn keypose_list(subject: &Subject, found: &KeyposeAnalysis) -> Json {
    let ranks = found.extraction.ranks();
    let kept = found.extraction.selection.kept.iter().enumerate();
    Json::list(kept.map(|(index, &candidate)| {
        let mut members = candidates::moment(subject, found, candidate, ranks[candidate]);
        let change = found.part_changes.get(index).map(part_percents);
        let words = found.postures.get(index);
        let posture = words.map(|words| Json::list(words.iter().map(|word| word.name())));
        members.push(("body_part_percents", change.into()));
        members.push(("posture", posture.into()));
        Json::Object(members)
    }))
}

fn part_percents(change: &PartChange) -> Json {
    let member = |part: BodyPart| (part.name(), change[part.index()].into());
    Json::object(BodyPart::ALL.map(member))
}

fn anova(test: &AnalysisOfVariance) -> Json {
    Json::object([
        ("f", test.f.into()),
        ("p", test.p.into()),
        ("df_between", test.df_between.into()),
        ("df_within", test.df_within.into()),
    ])
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
