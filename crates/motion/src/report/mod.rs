//! Results as text, the same bytes from the command line and the browser: an analysis goes in,
//! JSON Lines or CSV come out. The fields are described in `docs/formats.md`.

mod body;
mod candidates;
pub mod csv;
mod file;
mod keyposes;
mod provenance;
mod traces;

pub use body::source_name;
pub use provenance::VERSION;
pub use result_text::json;

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

/// What a report lists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Table {
    /// The keyposes; in JSON with everything else that was found.
    Keyposes,
    /// Every candidate.
    Candidates,
    /// Every candidate through the time scales.
    Traces,
}

/// JSON Lines: one object for each performer, each on a line of its own. `evaluations` are
/// those of the performers whose keyposes were held against marks, by the performer's index; only
/// the table of keyposes holds them.
pub fn json_lines(subject: &Subject, table: Table, evaluations: &[Option<Evaluation>]) -> String {
    let mut text = String::new();
    for (performer, found) in subject.analysis.performers.iter().enumerate() {
        let evaluation = evaluations.get(performer).and_then(Option::as_ref);
        let line = match table {
            Table::Keyposes => keyposes::object(subject, performer, found, evaluation),
            Table::Candidates => candidates::object(subject, performer, found),
            Table::Traces => traces::object(subject, performer, found),
        };
        text.push_str(&line.text());
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
