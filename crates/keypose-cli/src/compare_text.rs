//! A set compared, as text for a person.

use std::fmt::{self, Display, Formatter};

use comparison::evaluation;
use comparison::report::{Labels, Subject};

/// Shows the clusters in the order of the tree, and how well labels are told apart.
pub struct CompareText<'a>(pub Subject<'a>);

impl Display for CompareText<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Subject {
            names,
            comparison,
            cut,
            labels,
        } = self.0;
        let (clips, clusters) = (names.len(), cut.clusters);
        let pairs = comparison.distances.pairs();
        let counts = [
            counted(clips, "clip"),
            counted(pairs, "pair"),
            counted(clusters, "cluster"),
        ];
        writeln!(f, "{}", counts.join(", "))?;
        for cluster in 0..clusters {
            let leaves = comparison.order.leaves.iter();
            let members = leaves.filter(|item| cut.cluster_of_item[**item] == cluster);
            write!(f, "  cluster {cluster}")?;
            members
                .into_iter()
                .try_for_each(|item| write!(f, "  {}", names[*item]))?;
            writeln!(f)?;
        }
        labels.map_or(Ok(()), |labels| self.write_scores(f, labels))
    }
}

impl CompareText<'_> {
    fn write_scores(&self, f: &mut Formatter<'_>, labels: &Labels) -> fmt::Result {
        let Subject {
            names,
            comparison,
            cut,
            ..
        } = self.0;
        let nearest = comparison.one_nearest(&labels.of_item);
        let scores = evaluation::clustering(&cut.cluster_of_item, &labels.of_item);
        let (different, labelled) = (labels.names.len(), nearest.labelled);
        let of = counted(labelled, "clip");
        let without = counted(names.len() - labelled, "clip");
        writeln!(f, "  labels    {different} of {of}, {without} without")?;
        if labelled == 0 {
            return Ok(());
        }
        writeln!(
            f,
            "  nearest   {} of {} right, accuracy {:.3} of at most {:.3}",
            nearest.correct, nearest.labelled, nearest.accuracy, nearest.best_reachable
        )?;
        for (clip, near) in &nearest.errors {
            writeln!(f, "    {} is nearest to {}", names[*clip], names[*near])?;
        }
        writeln!(
            f,
            "  clusters  recall {:.3} precision {:.3} F {:.3}",
            scores.recall, scores.precision, scores.f
        )
    }
}

fn counted(count: usize, noun: &str) -> String {
    match count {
        1 => format!("1 {noun}"),
        _ => format!("{count} {noun}s"),
    }
}
