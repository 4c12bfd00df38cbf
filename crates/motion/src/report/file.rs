//! The head of every object: which file and performer it is of, and what it was made with.

use super::Subject;
use super::json::Json;
use super::provenance::{VERSION, parameters};

/// The members of an object in JSON.
pub type Members = Vec<(&'static str, Json)>;

/// `file` to `frame_rate_source`, `version` and `parameters`.
pub fn members(subject: &Subject, performer: usize) -> Members {
    let analysis = subject.analysis;
    vec![
        ("file", subject.file.into()),
        ("performer", performer.into()),
        ("sha256", subject.sha256.into()),
        ("version", VERSION.into()),
        ("parameters", parameters(&analysis.options)),
        ("frames", subject.clip.frames.into()),
        ("frame_time_s", analysis.frame_time_s.into()),
        ("frame_rate_hz", (1.0 / analysis.frame_time_s).into()),
        (
            "frame_rate_source",
            analysis.frame_time_source.name().into(),
        ),
    ]
}
