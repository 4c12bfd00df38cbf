//! The body in a report: which joint is which, by the labels of the skeleton.

use super::json::Json;
use crate::analysis::PerformerAnalysis;
use crate::body::{BodyJoint, Role, Source};

/// `body`: kind, pelvis, height, joints.
pub fn body(performer: &PerformerAnalysis, labels: &[String]) -> Json {
    let body = &performer.survey.body;
    let label = |joint: usize| labels.get(joint).map(String::as_str);
    let joint = |found: &BodyJoint| {
        Json::object([
            ("role", found.role.name().into()),
            ("joint", label(found.joint).into()),
            ("source", source_name(found.source).into()),
        ])
    };
    let is_listed = |found: &&BodyJoint| body.is_human() && found.role != Role::Pelvis;
    Json::object([
        (
            "kind",
            if body.is_human() { "human" } else { "other" }.into(),
        ),
        ("pelvis", label(body.pelvis).into()),
        ("height", performer.survey.height.into()),
        (
            "joints",
            Json::list(body.joints.iter().filter(is_listed).map(joint)),
        ),
    ])
}

/// The name of a joint's source in machine-readable output.
pub fn source_name(source: Source) -> &'static str {
    match source {
        Source::Name => "name",
        Source::Shape => "shape",
        Source::User => "user",
        Source::Fallback => "fallback",
    }
}
