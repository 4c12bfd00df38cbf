//! The candidates' way through the time scales in a report.

use super::Subject;
use super::file;
use super::json::Json;
use crate::analysis::{KeyposeAnalysis, PerformerAnalysis};

/// The object of one performer: the head, `scales_hz` and `traces`.
pub fn object(subject: &Subject, performer: usize, found: &PerformerAnalysis) -> Json {
    let mut members = file::members(subject, performer);
    let keyposes = found.keyposes.as_ref().ok();
    let scales_hz = keyposes.map_or(&[][..], |found| &found.extraction.scales_hz);
    members.push(("scales_hz", Json::list(scales_hz.iter().copied())));
    members.push(("traces", keyposes.map_or(Json::List(Vec::new()), traces)));
    Json::Object(members)
}

/// One object a candidate; the k-th element of its lists is of the k-th scale.
fn traces(found: &KeyposeAnalysis) -> Json {
    let (traces, first) = (&found.extraction.traces, found.first_frame);
    Json::list((0..found.extraction.candidates.len()).map(|candidate| {
        let entries = traces.entries(candidate);
        let frames = traces.frames[entries.clone()].iter();
        let places = traces.places[entries.clone()].iter();
        let u = traces.contributions[entries].iter();
        Json::object([
            ("candidate", found.frame_of(candidate).into()),
            ("frames", Json::list(frames.map(|frame| first + frame))),
            (
                "places",
                Json::list(places.map(|place| first as f64 + place)),
            ),
            ("u", Json::list(u.copied())),
        ])
    }))
}
