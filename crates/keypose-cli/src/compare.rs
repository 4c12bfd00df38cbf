//! `keypose compare`: a set of files compared, as JSON, a table, Newick, or text for a person.

use std::io::{self, BufWriter, Write};

use anyhow::{Context, Result};
use comparison::comparison::Comparison;
use comparison::report::{Labels, Subject, evaluation_csv, set_json};

use crate::arguments::Compare;
use crate::compare_text::CompareText;
use crate::surveys::Surveys;

/// Compares all files that can be compared. Returns whether every file could be read.
///
/// # Errors
/// Options that cannot be or do not go together, or output that cannot be
/// written.
pub fn write(wanted: &Compare, threads: usize) -> Result<bool> {
    let settings = wanted.settings();
    settings.validate()?;
    let all = Surveys::of(&wanted.paths, &wanted.overrides, threads)?;
    let labels = wanted.labels.as_ref().map(|rule| {
        let paths = all.files.iter().map(|file| rule.label(&file.place));
        Labels::new(paths)
    });
    if let Some(labels) = &labels {
        report_unlabelled(labels);
    }
    let comparison = Comparison::of(all.features(), settings).context("comparing")?;
    let subject = Subject {
        names: &all.names,
        comparison: &comparison,
        cut: &comparison.cut(comparison.automatic_clusters),
        labels: labels.as_ref(),
    };
    let mut out = BufWriter::new(io::stdout());
    out.write_all(text(wanted, &all, &subject).as_bytes())?;
    out.flush()?;
    Ok(all.all_good)
}

/// Says on standard error how many clips no label was found for, if any.
fn report_unlabelled(labels: &Labels) {
    let all = labels.of_item.len();
    let without = all - labels.of_item.iter().flatten().count();
    if without > 0 {
        eprintln!("{without} of {all} clips have no label; they are left out of the scores");
    }
}

fn text(wanted: &Compare, all: &Surveys, subject: &Subject) -> String {
    match (wanted.json, wanted.csv, wanted.newick) {
        (true, ..) => {
            let sha256: Vec<String> = all.files.iter().map(|file| file.sha256.clone()).collect();
            set_json(subject, &sha256, &all.left_out)
        }
        (_, true, _) => evaluation_csv(subject),
        (.., true) => subject.newick(),
        _ => CompareText(*subject).to_string(),
    }
}
