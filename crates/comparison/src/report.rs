//! Results as text and bytes, the same from the command line and the browser: a set compared goes in;
//! CSV, JSON, `.npy` and Newick come out. The fields are described in `docs/formats.md`.

mod evaluation;
mod features;
mod file_run;
mod labels;
mod matrix;
mod npy;
mod provenance;
mod set;

pub use evaluation::evaluation_csv;
pub use features::{features_csv, features_npy};
pub use file_run::{FileKind, FileRun};
pub use labels::Labels;
pub use provenance::{VERSION, feature_parameters};
pub use set::{LeftOut, set_json};

use crate::comparison::{Comparison, Cut};
use crate::settings::CutRule;

/// What a report is about: a set compared, its names, a cut and labels.
#[derive(Clone, Copy)]
pub struct Subject<'a> {
    /// What the report calls each clip.
    pub names: &'a [String],
    /// Their comparison.
    pub comparison: &'a Comparison,
    /// A cut of its tree.
    pub cut: &'a Cut,
    /// Labels of the clips; none where nobody gave any.
    pub labels: Option<&'a Labels>,
}

impl<'a> Subject<'a> {
    /// How the number of clusters was found.
    fn rule(&self) -> CutRule {
        match self.cut.clusters == self.comparison.automatic_clusters {
            true => self.comparison.settings.rule(),
            false => CutRule::Number(self.cut.clusters),
        }
    }

    /// The label of a clip in words; none without.
    fn label_of(&self, item: usize) -> Option<&'a str> {
        self.labels?.of(item)
    }

    /// The tree as Newick with its leaves in their order, on a line of its own.
    pub fn newick(&self) -> String {
        let Comparison { tree, order, .. } = self.comparison;
        tree.newick(&order.leaves, self.names) + "\n"
    }
}
