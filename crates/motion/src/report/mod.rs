//! Results as text, the same bytes from the command line and the browser: an analysis goes in,
//! JSON Lines or CSV come out. The fields are described in `docs/formats.md`.

mod body;
pub mod csv;
pub mod json;
mod keyposes;

pub use body::source_name;
pub use keyposes::json_line;

use crate::analysis::Analysis;
use crate::clip::Clip;
use crate::keypose::evaluation::Evaluation;
use crate::rest::{LeadingRest, RestReason};

/// What a report is about: one file, read and analysed.
#[derive(Clone, Copy, Debug)]
pub struct Subject<'a> {
    /// The file as the report names it.
    pub file: &'a str,
    /// The SHA-256 of its bytes, in hexadecimal.
    pub sha256: &'a str,
    /// What was read; its values may be gone.
    pub clip: &'a Clip,
    /// What was found.
    pub analysis: &'a Analysis,
}

/// JSON Lines: one object for each performer, each on a line of its own. `evaluations` are
/// those of the performers whose keyposes were held against marks, by the performer's index.
pub fn json_lines(subject: &Subject, evaluations: &[Option<Evaluation>]) -> String {
    let mut text = String::new();
    for performer in 0..subject.analysis.performers.len() {
        let evaluation = evaluations.get(performer).and_then(Option::as_ref);
        text.push_str(&json_line(subject, performer, evaluation).text());
        text.push('\n');
    }
    text
}

/// Why frames were left out, in machine-readable output.
pub fn reason_name(rest: LeadingRest) -> &'static str {
    match rest.reason {
        None => "none",
        Some(RestReason::TPose) => "t-pose",
        Some(RestReason::BlendedTPose) => "blended-t-pose",
        Some(RestReason::Jump) => "jump",
        Some(RestReason::ByHand) => "user",
    }
}
