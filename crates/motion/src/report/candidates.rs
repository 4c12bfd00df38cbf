//! The candidates in a report, and what is told of each wherever it is listed.

use super::Subject;
use super::file::{self, Members};
use super::json::Json;
use crate::analysis::{KeyposeAnalysis, PerformerAnalysis};

/// The object of one performer: the head and its `candidates`.
pub fn object(subject: &Subject, performer: usize, found: &PerformerAnalysis) -> Json {
    let mut members = file::members(subject, performer);
    let keyposes = found.keyposes.as_ref().ok();
    let list = keyposes.map_or(Json::List(Vec::new()), |found| list(subject, found));
    members.push(("candidates", list));
    Json::Object(members)
}

/// All candidates in time order, each with whether it is a keypose.
pub fn list(subject: &Subject, found: &KeyposeAnalysis) -> Json {
    let kept = &found.extraction.selection.kept;
    let ranks = found.extraction.ranks();
    Json::list(ranks.into_iter().enumerate().map(|(candidate, rank)| {
        let mut members = moment(subject, found, candidate, rank);
        let is_keypose = kept.binary_search(&candidate).is_ok();
        members.push(("is_keypose", is_keypose.into()));
        Json::Object(members)
    }))
}

/// Frame, time, intensity, rank and strongest scale of a candidate.
pub fn moment(
    subject: &Subject,
    found: &KeyposeAnalysis,
    candidate: usize,
    rank: usize,
) -> Members {
    let frame = found.frame_of(candidate);
    vec![
        ("frame", frame.into()),
        (
            "time_s",
            (frame as f64 * subject.analysis.frame_time_s).into(),
        ),
        ("intensity", found.extraction.intensity[candidate].into()),
        ("rank", rank.into()),
        ("strongest_hz", found.strongest_hz(candidate).into()),
    ]
}
