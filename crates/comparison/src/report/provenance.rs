//! What a result was made with: the version of the core and every parameter.

use result_text::json::{Json, number};

use super::Subject;
use crate::cut::mojena;
use crate::distance::Distance;
use crate::settings::CutRule;

/// The version of this crate, which all results name.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// What the features depend on.
pub fn feature_parameters(distance: Distance) -> Vec<(&'static str, Json)> {
    vec![
        ("distance", distance.name().into()),
        ("across_rigs", distance.choice().across_rigs.into()),
    ]
}

/// The same as one field of a table.
pub fn feature_parameters_text(distance: Distance) -> String {
    let (name, across_rigs) = (distance.name(), distance.choice().across_rigs);
    format!("distance={name} across_rigs={across_rigs}")
}

/// What the tree and the cut depend on too.
pub fn parameters(subject: &Subject) -> Json {
    let settings = subject.comparison.settings;
    let mut members = feature_parameters(settings.distance);
    members.extend([
        (
            "mirror_aware",
            settings.distance.choice().mirror_aware.into(),
        ),
        ("linkage", settings.linkage.name().into()),
        ("cut", subject.rule().name().into()),
        ("mojena_k", mojena_k(subject).into()),
    ]);
    Json::Object(members)
}

/// The same as one field of a table.
pub fn parameters_text(subject: &Subject) -> String {
    let settings = subject.comparison.settings;
    let mut text = feature_parameters_text(settings.distance);
    let mirror_aware = settings.distance.choice().mirror_aware;
    let (linkage, cut) = (settings.linkage.name(), subject.rule().name());
    text.push_str(&format!(
        " mirror_aware={mirror_aware} linkage={linkage} cut={cut}"
    ));
    if let Some(k) = mojena_k(subject) {
        text.push_str(&format!(" mojena_k={}", number(k)));
    }
    text
}

/// The deviations of Mojena's rule, where it cuts.
fn mojena_k(subject: &Subject) -> Option<f64> {
    (subject.rule() == CutRule::Mojena).then_some(mojena::DEVIATIONS)
}
