//! A tree in; how many clusters it is best cut into, out.

pub mod bic;
pub mod mojena;

use crate::dendrogram::Dendrogram;
use crate::feature::Vector;
use crate::settings::CutRule;

/// How many clusters a rule finds (at least 1, but 0 without items), and the criterion of 1, 2, …
/// clusters that says so, where there is one.
pub(crate) fn clusters(rule: CutRule, vectors: &[Vector], tree: &Dendrogram) -> (usize, Vec<f64>) {
    let (clusters, bic) = match rule {
        CutRule::Number(clusters) => (clusters.max(1), Vec::new()),
        CutRule::Bic => {
            let values = bic::bic(vectors, tree);
            (bic::best(&values), values)
        }
        CutRule::Mojena => {
            let heights: Vec<f64> = tree.merges.iter().map(|merge| merge.height).collect();
            (mojena::mojena(&heights, mojena::DEVIATIONS), Vec::new())
        }
    };
    (clusters.min(tree.items), bic)
}
