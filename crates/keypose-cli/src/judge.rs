//! Keyposes held against marks, and the means over all files.

use std::fmt::{self, Display, Formatter};

use motion::analysis::PerformerAnalysis;
use motion::keypose::evaluation::{Evaluation, Span, evaluate};

use crate::marks::Marks;
use crate::study::Study;

/// Judges each performer of a study; none for a file without marks.
pub fn judge(study: &Study, marks: Option<&Marks>, span: Span) -> Vec<Option<Evaluation>> {
    let Some(marks) = marks.and_then(|marks| marks.of(&study.label)) else {
        return Vec::new();
    };
    let judged = |performer: &PerformerAnalysis| {
        let keyposes = performer.keyposes.as_ref().ok()?;
        Some(evaluate(&keyposes.keyposes(), marks, span))
    };
    study.analysis.performers.iter().map(judged).collect()
}

/// The means of precision, recall and F over all that was judged.
#[derive(Clone, Copy, Debug, Default)]
pub struct Means {
    count: usize,
    precision: f64,
    recall: f64,
    f: f64,
}

impl Means {
    /// Takes the evaluations of one file in.
    pub fn add(&mut self, evaluations: &[Option<Evaluation>]) {
        for evaluation in evaluations.iter().flatten() {
            self.count += 1;
            self.precision += evaluation.precision;
            self.recall += evaluation.recall;
            self.f += evaluation.f;
        }
    }
}

impl Display for Means {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        if self.count == 0 {
            return write!(f, "no file has marks");
        }
        let mean = |sum: f64| sum / self.count as f64;
        write!(
            f,
            "{} with marks: mean precision {:.4}, recall {:.4}, F {:.4}",
            self.count,
            mean(self.precision),
            mean(self.recall),
            mean(self.f)
        )
    }
}
