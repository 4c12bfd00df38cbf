//! What the engine says of a clip in words and single numbers, as JSON: `ClipSummary` of `raw.ts`.
//! The series come as arrays of their own.

use motion::analysis::{
    Analysis, KeyposeAnalysis, PerformerAnalysis, PerformerSurvey, Source, Survey,
};
use motion::body::{Body, BodyJoint, Role};
use motion::clip::Clip;
use motion::note::Note;
use motion::posture::PostureWord;
use motion::report::json::Json;
use motion::report::{reason_name, source_name};
use motion::world::Unit;

use crate::failure;
use crate::settings::unit_name;

/// The summary of a clip and its analysis.
pub fn summary(clip: &Clip, analysis: &Analysis) -> Json {
    let performers = analysis.performers.iter().zip(&clip.performers);
    let performer = |(found, owner): (&PerformerAnalysis, &motion::clip::Performer)| {
        performer(found, owner.skeleton.labels())
    };
    Json::object([
        ("frames", clip.frames.into()),
        ("frameTimeS", analysis.frame_time_s.into()),
        ("frameTimeSource", analysis.frame_time_source.name().into()),
        ("notes", notes(clip.notes.iter())),
        ("performers", Json::list(performers.map(performer))),
    ])
}

/// The summary of a clip and its survey: `ClipSurvey` of `raw.ts`.
pub fn survey(clip: &Clip, survey: &Survey) -> Json {
    let performers = survey.performers.iter().zip(&clip.performers);
    let performer = |(found, owner): (&PerformerSurvey, &motion::clip::Performer)| {
        let mut members = facts(found, owner.skeleton.labels(), found.notes.iter());
        members.push(("analysedFrames", found.frames.into()));
        Json::Object(members)
    };
    Json::object([
        ("frames", clip.frames.into()),
        ("frameTimeS", survey.frame_time_s.into()),
        ("frameTimeSource", survey.frame_time_source.name().into()),
        ("notes", notes(clip.notes.iter())),
        ("performers", Json::list(performers.map(performer))),
    ])
}

fn performer(found: &PerformerAnalysis, labels: Vec<String>) -> Json {
    let mut members = facts(&found.survey, labels, found.notes());
    members.extend([
        (
            "keyposes",
            found.keyposes.as_ref().ok().map(keyposes).into(),
        ),
        (
            "unanalysed",
            found.keyposes.as_ref().err().map(failure::of_note).into(),
        ),
        ("thumbnailFrame", found.thumbnail_frame.into()),
        ("sideYawRad", found.side_yaw_rad.into()),
    ]);
    Json::Object(members)
}

/// What survey and analysis both say of a performer.
fn facts<'a>(
    found: &PerformerSurvey,
    labels: Vec<String>,
    all_notes: impl Iterator<Item = &'a Note>,
) -> Vec<(&'static str, Json)> {
    let up = Json::object([
        ("axis", found.up.0.name().into()),
        ("source", found.up.1.name().into()),
    ]);
    vec![
        ("labels", Json::list(labels)),
        ("body", body(&found.body, found.height)),
        ("up", up),
        ("groundHeight", found.ground_height.into()),
        ("unit", found.unit.map(unit).into()),
        ("leadingRestFrames", found.leading_rest.frames.into()),
        ("leadingRestReason", reason_name(found.leading_rest).into()),
        ("frontYawRad", found.front_yaw_rad.into()),
        ("notes", notes(all_notes)),
    ]
}

fn unit((unit, source): (Unit, Source)) -> Json {
    Json::object([
        ("name", unit_name(unit).into()),
        ("metres", unit.metres().into()),
        ("source", source.name().into()),
    ])
}

fn body(body: &Body, height: f64) -> Json {
    let joint = |joint: &BodyJoint| {
        Json::object([
            ("role", joint.role.name().into()),
            ("joint", joint.joint.into()),
            ("source", source_name(joint.source).into()),
        ])
    };
    let is_listed = |joint: &&BodyJoint| body.is_human() && joint.role != Role::Pelvis;
    Json::object([
        (
            "kind",
            if body.is_human() { "human" } else { "other" }.into(),
        ),
        ("pelvis", body.pelvis.into()),
        ("height", height.into()),
        (
            "joints",
            Json::list(body.joints.iter().filter(is_listed).map(joint)),
        ),
    ])
}

fn keyposes(found: &KeyposeAnalysis) -> Json {
    let selection = &found.extraction.selection;
    let sureness = found.extraction.sureness;
    let anova = selection.analysis_of_variance.as_ref().map(|test| {
        Json::object([
            ("f", test.f.into()),
            ("p", test.p.into()),
            ("betweenDegrees", test.df_between.into()),
            ("withinDegrees", test.df_within.into()),
        ])
    });
    Json::object([
        ("firstFrame", found.first_frame.into()),
        (
            "maximumSpeed",
            found.speed.iter().copied().fold(0.0, f64::max).into(),
        ),
        ("clusters", selection.clusters.into()),
        ("anova", anova.into()),
        ("sureness", sureness.ratio.into()),
        ("cut", sureness.cut().into()),
        (
            "postures",
            Json::list(found.postures.iter().map(|one| words(one))),
        ),
    ])
}

fn words(posture: &[PostureWord]) -> Json {
    Json::list(posture.iter().map(|word| word.name()))
}

fn notes<'a>(notes: impl Iterator<Item = &'a Note>) -> Json {
    Json::list(notes.map(|note| {
        Json::object([
            ("kind", note.kind.name().into()),
            ("line", note.line.into()),
            ("column", note.column.into()),
            ("frame", note.frame.into()),
            (
                "details",
                Json::list(note.details.iter().map(String::as_str)),
            ),
        ])
    }))
}
