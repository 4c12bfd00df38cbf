//! The `keypose` command: what is in motion capture files, and their keyposes.

mod arguments;
mod compare;
mod compare_text;
mod features;
mod files;
mod in_order;
mod inspect;
mod judge;
mod keyposes_text;
mod labels;
mod marks;
mod samples;
mod study;
mod surveys;

use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use anyhow::Result;
use clap::Parser;
use indicatif::{ProgressBar, ProgressStyle};
use motion::keypose::Options;
use motion::keypose::evaluation::Evaluation;
use motion::report::{self, csv};

use crate::arguments::{Arguments, Command, Inspect, Keyposes};
use crate::inspect::Inspection;
use crate::judge::{Means, judge};
use crate::keyposes_text::KeyposesText;
use crate::marks::Marks;
use crate::study::{Study, Wishes};

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let result = match &arguments.command {
        Command::Inspect(inspect) => run_inspect(inspect, arguments.threads),
        Command::Keyposes(keyposes) => run_keyposes(keyposes, arguments.threads),
        Command::Features(wanted) => features::write(wanted, arguments.threads),
        Command::Compare(wanted) => compare::write(wanted, arguments.threads),
        Command::Samples(wanted) => samples::write_all(&wanted.folder, &wanted.ids).map(|()| true),
    };
    match result {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) if is_closed_pipe(&error) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("keypose: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn run_inspect(inspect: &Inspect, threads: usize) -> Result<bool> {
    let work = Work {
        paths: &inspect.paths,
        wishes: Wishes::new(&inspect.overrides)?,
        options: Options::default(),
        threads,
    };
    let show = |study: &Study| Inspection(study).to_string();
    work.run(show, |out, text| Ok(out.write_all(text.as_bytes())?))
}

fn run_keyposes(keyposes: &Keyposes, threads: usize) -> Result<bool> {
    let options = keyposes.method.options();
    options.validate()?;
    let marks = keyposes.marks.as_deref().map(Marks::read).transpose()?;
    let work = Work {
        paths: &keyposes.paths,
        wishes: Wishes::new(&keyposes.overrides)?,
        options,
        threads,
    };
    let mut means = Means::default();
    let mut head = match keyposes.csv {
        true => csv::header(keyposes.table()),
        false => "",
    };
    let show = |study: &Study| {
        let evaluations = judge(study, marks.as_ref(), keyposes.span());
        (keyposes_text(keyposes, study, &evaluations), evaluations)
    };
    let all_good = work.run(show, |out, (text, evaluations)| {
        out.write_all(std::mem::take(&mut head).as_bytes())?;
        means.add(&evaluations);
        Ok(out.write_all(text.as_bytes())?)
    })?;
    if marks.is_some() {
        eprintln!("{means}");
    }
    Ok(all_good)
}

/// The keyposes of a file in the form that was asked for.
fn keyposes_text(keyposes: &Keyposes, study: &Study, evaluations: &[Option<Evaluation>]) -> String {
    let table = keyposes.table();
    match (keyposes.json, keyposes.csv) {
        (true, _) => report::json_lines(&study.subject(), table, evaluations),
        (_, true) => csv::rows(&study.subject(), table),
        _ => KeyposesText { study, evaluations }.to_string(),
    }
}

/// What is done to all files of a call.
struct Work<'a> {
    paths: &'a [PathBuf],
    wishes: Wishes,
    options: Options,
    threads: usize,
}

impl Work<'_> {
    /// Studies every file at once with others and emits what `show` makes of it in the order of
    /// the files; errors go to standard error. Returns whether every file could be read.
    fn run<R: Send>(
        &self,
        show: impl Fn(&Study) -> R + Sync,
        mut emit: impl FnMut(&mut dyn Write, R) -> Result<()>,
    ) -> Result<bool> {
        let inputs = files::collect(self.paths);
        let mut all_good = inputs.report();
        let progress = progress_bar(inputs.files.len());
        let mut out = BufWriter::new(io::stdout());
        let study = |file: &_| Study::of(file, &self.wishes, &self.options).map(|s| show(&s));
        in_order::for_each(&inputs.files, self.threads, study, |result| {
            progress.inc(1);
            match result {
                Ok(shown) => emit(&mut out, shown),
                Err(error) => {
                    all_good = false;
                    progress.suspend(|| eprintln!("{error:#}"));
                    Ok(())
                }
            }
        })?;
        progress.finish_and_clear();
        out.flush()?;
        Ok(all_good)
    }
}

/// A bar on standard error; silent where that is no terminal, and on short work.
fn progress_bar(files: usize) -> ProgressBar {
    if files < 2 {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} files, {eta} left");
    ProgressBar::new(files as u64)
        .with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

/// Whether the reader of our output went away, as `head` does: no fault of anyone.
fn is_closed_pipe(error: &anyhow::Error) -> bool {
    let cause = error.downcast_ref::<io::Error>();
    cause.is_some_and(|error| error.kind() == ErrorKind::BrokenPipe)
}
