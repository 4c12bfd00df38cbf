//! Files in; of each that can be compared, its feature out, in the order of the files. The others say
//! why on standard error.

use std::path::PathBuf;
use std::rc::Rc;

use anyhow::{Context, Result};
use comparison::feature::ClipFeature;
use comparison::report::LeftOut;
use motion::analysis::{self, Survey};
use motion::feature::ComparableFeature;

use crate::arguments::Overrides;
use crate::files::{self, InputFile};
use crate::study::{self, Wishes};
use crate::{in_order, progress_bar};

/// A file that can be compared.
#[derive(Debug)]
pub struct Surveyed {
    /// Where it is from the root.
    pub place: PathBuf,
    /// The SHA-256 of its bytes, in hexadecimal.
    pub sha256: String,
    /// Which performer is compared: the first human one.
    pub performer: usize,
    /// How many frames are compared.
    pub frames: usize,
    /// What is compared.
    pub feature: ClipFeature,
}

/// The files of a call.
#[derive(Debug, Default)]
pub struct Surveys {
    /// What output calls each file that can be compared.
    pub names: Vec<String>,
    /// Those files.
    pub files: Vec<Surveyed>,
    /// Readable files that cannot be compared.
    pub left_out: Vec<LeftOut>,
    /// Whether every file could be read.
    pub all_good: bool,
}

impl Surveys {
    /// Surveys all files with `threads` threads (0: one for each processor).
    ///
    /// # Errors
    /// An option that cannot be.
    pub fn of(paths: &[PathBuf], overrides: &Overrides, threads: usize) -> Result<Self> {
        let wishes = Wishes::new(overrides)?;
        let inputs = files::collect(paths);
        let mut all = Self {
            all_good: inputs.report(),
            ..Self::default()
        };
        let progress = progress_bar(inputs.files.len());
        let mut next = inputs.files.iter();
        in_order::for_each(
            &inputs.files,
            threads,
            |file| survey(file, &wishes),
            |result| {
                progress.inc(1);
                let file = next.next().context("a result of no file")?;
                if let Some(said) = all.add(file, result) {
                    progress.suspend(|| eprintln!("{said}"));
                }
                Ok(())
            },
        )?;
        progress.finish_and_clear();
        Ok(all)
    }

    /// The features, as a comparison shares them.
    pub fn features(&self) -> Vec<Rc<ClipFeature>> {
        let features = self.files.iter();
        features.map(|file| Rc::new(file.feature.clone())).collect()
    }

    /// Adds a file. Returns what is to be said of one that is not compared.
    fn add(
        &mut self,
        file: &InputFile,
        result: Result<Result<Surveyed, &'static str>>,
    ) -> Option<String> {
        match result {
            Ok(Ok(surveyed)) => {
                self.names.push(file.label.clone());
                self.files.push(surveyed);
                None
            }
            Ok(Err(reason)) => {
                self.left_out.push(LeftOut {
                    name: file.label.clone(),
                    reason,
                });
                Some(format!(
                    "{}: left out: {}",
                    file.path.display(),
                    sentence(reason)
                ))
            }
            Err(error) => {
                self.all_good = false;
                Some(format!("{error:#}"))
            }
        }
    }
}

/// A file's survey, or why it cannot be compared.
fn survey(file: &InputFile, wishes: &Wishes) -> Result<Result<Surveyed, &'static str>> {
    let (clip, sha256) = study::read(file)?;
    let decisions = wishes
        .decisions(&clip)
        .with_context(|| file.path.display().to_string())?;
    let survey = analysis::survey(&clip, &decisions)?;
    let mut performers = survey.performers.iter().enumerate();
    let found =
        performers.find_map(|(index, found)| Some((index, found, found.comparable.as_ref()?)));
    Ok(match found {
        None => Err(reason(&survey)),
        Some((performer, found, comparable)) => Ok(Surveyed {
            place: file.place.clone(),
            sha256,
            performer,
            frames: found.frames,
            feature: clip_feature(comparable),
        }),
    })
}

fn clip_feature(found: &ComparableFeature) -> ClipFeature {
    ClipFeature {
        recorded: found.recorded,
        across_rigs: found.across_rigs,
        recorded_by_joint: found.recorded_by_joint,
        across_rigs_by_joint: found.across_rigs_by_joint,
    }
}

/// Why nobody in a clip can be compared.
fn reason(survey: &Survey) -> &'static str {
    let mut performers = survey.performers.iter();
    match performers.any(|found| found.body.is_human()) {
        true => "too-short",
        false => "not-human",
    }
}

fn sentence(reason: &str) -> &'static str {
    match reason {
        "too-short" => "the motion has fewer than two frames",
        _ => "the body is not human",
    }
}
