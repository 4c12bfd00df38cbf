//! The keyposes of a file, as text for a person.

use std::fmt::{self, Display, Formatter};

use motion::analysis::PerformerAnalysis;
use motion::keypose::evaluation::Evaluation;

use crate::study::Study;

/// Shows the keyposes of each performer, a line each, and how they compare with marks.
pub struct KeyposesText<'a> {
    /// What was found.
    pub study: &'a Study,
    /// One for each performer, where there are marks.
    pub evaluations: &'a [Option<Evaluation>],
}

impl Display for KeyposesText<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let performers = &self.study.analysis.performers;
        for (index, performer) in performers.iter().enumerate() {
            write!(f, "{}", self.study.label)?;
            if performers.len() > 1 {
                write!(f, " performer {index}")?;
            }
            self.write_keyposes(f, performer)?;
            if let Some(Some(evaluation)) = self.evaluations.get(index) {
                let Evaluation {
                    precision,
                    recall,
                    f: score,
                    ..
                } = evaluation;
                write!(
                    f,
                    "  precision {precision:.3} recall {recall:.3} F {score:.3}"
                )?;
            }
            writeln!(f)?;
        }
        Ok(())
    }
}

impl KeyposesText<'_> {
    fn write_keyposes(&self, f: &mut Formatter<'_>, performer: &PerformerAnalysis) -> fmt::Result {
        match &performer.keyposes {
            Err(note) => write!(f, ": {}", note.message()),
            Ok(keyposes) => {
                let frames = keyposes.keyposes();
                let found = keyposes.extraction.candidates.len();
                write!(
                    f,
                    ": {} keyposes of {found} candidates, frames",
                    frames.len()
                )?;
                frames.iter().try_for_each(|frame| write!(f, " {frame}"))
            }
        }
    }
}
