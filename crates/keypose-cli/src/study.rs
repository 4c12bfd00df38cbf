//! One file in; what was read and found in it out.

use std::fmt::Write as _;
use std::fs::File;
use std::io::Read;

use anyhow::{Context, Result, anyhow};
use motion::analysis::{self, Analysis, Decisions};
use motion::bvh::{ParseError, Reader};
use motion::clip::Clip;
use motion::keypose::Options;
use motion::report::Subject;
use motion::world::Up;
use sha2::{Digest, Sha256};

use crate::arguments::Overrides;
use crate::files::InputFile;

const SLICE_BYTES: usize = 4 << 20;

/// A file, read and analysed.
#[derive(Debug)]
pub struct Study {
    /// What output calls the file.
    pub label: String,
    /// The SHA-256 of its bytes, in hexadecimal.
    pub sha256: String,
    /// What was read.
    pub clip: Clip,
    /// What was found.
    pub analysis: Analysis,
}

impl Study {
    /// Reads a file in slices and analyses it.
    ///
    /// # Errors
    /// One line that names the file, and the line and column where it cannot be read.
    pub fn of(file: &InputFile, decisions: &Decisions, options: &Options) -> Result<Self> {
        let (clip, sha256) = read(file)?;
        let analysis = analysis::analyse(&clip, decisions, options)?;
        Ok(Self {
            label: file.label.clone(),
            sha256,
            clip,
            analysis,
        })
    }

    /// The study as the core's reports take it.
    pub fn subject(&self) -> Subject<'_> {
        Subject {
            file: &self.label,
            sha256: &self.sha256,
            clip: &self.clip,
            analysis: &self.analysis,
        }
    }
}

/// What the command line decides about every file.
///
/// # Errors
/// An option with a value that it cannot have.
pub fn decisions(overrides: &Overrides) -> Result<Decisions> {
    let up = overrides.up.as_deref().map(up_from_name).transpose()?;
    let decisions = Decisions {
        frame_rate_hz: overrides.frame_rate_hz,
        leading_rest_frames: overrides.leading_rest_frames,
        up,
        unit: None,
    };
    decisions.validate()?;
    Ok(decisions)
}

fn up_from_name(name: &str) -> Result<Up> {
    Up::from_name(name)
        .with_context(|| format!("--up is {name}; expected +X, -X, +Y, -Y, +Z or -Z"))
}

fn read(file: &InputFile) -> Result<(Clip, String)> {
    let shown = file.path.display();
    let mut source = File::open(&file.path).with_context(|| shown.to_string())?;
    let total = source.metadata().with_context(|| shown.to_string())?.len();
    let mut reader = Reader::new(Some(total));
    let mut hash = Sha256::new();
    let mut slice = vec![0; SLICE_BYTES.min(usize::try_from(total).unwrap_or(SLICE_BYTES) + 1)];
    loop {
        let count = source.read(&mut slice).with_context(|| shown.to_string())?;
        if count == 0 {
            break;
        }
        hash.update(&slice[..count]);
        reader
            .push(&slice[..count])
            .map_err(|error| placed(file, &error))?;
    }
    let clip = reader.finish().map_err(|error| placed(file, &error))?;
    Ok((clip, hexadecimal(&hash.finalize())))
}

/// `file:line:column: message`, as editors and terminals know it.
fn placed(file: &InputFile, error: &ParseError) -> anyhow::Error {
    let (path, message) = (file.path.display(), error.message());
    anyhow!("{path}:{}:{}: {message}", error.line, error.column)
}

fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().fold(String::new(), |mut text, byte| {
        // Writing to a String does not fail.
        let _ = write!(text, "{byte:02x}");
        text
    })
}
