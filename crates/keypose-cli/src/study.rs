//! One file in; what was read and found in it out.

use std::fmt::Write as _;
use std::fs::File;
use std::io::Read;

use anyhow::{Context, Result, anyhow, bail};
use motion::analysis::{self, Analysis, Decisions, JointDecision};
use motion::body::Role;
use motion::bvh::{ParseError, Reader};
use motion::clip::Clip;
use motion::keypose::Options;
use motion::report::Subject;
use motion::world::{Unit, Up};
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
    pub fn of(file: &InputFile, wishes: &Wishes, options: &Options) -> Result<Self> {
        let (clip, sha256) = read(file)?;
        let name = || file.path.display().to_string();
        let decisions = wishes.decisions(&clip).with_context(name)?;
        let analysis = analysis::analyse(&clip, &decisions, options)?;
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
#[derive(Clone, Debug)]
pub struct Wishes {
    decisions: Decisions,
    /// Parts of the body with the labels of joints.
    joints: Vec<(Role, String)>,
}

impl Wishes {
    /// The wishes of the options given.
    ///
    /// # Errors
    /// An option with a value that it cannot have.
    pub fn new(overrides: &Overrides) -> Result<Self> {
        let decisions = Decisions {
            frame_rate_hz: overrides.frame_rate_hz,
            leading_rest_frames: overrides.leading_rest_frames,
            up: overrides.up.as_deref().map(up_from_name).transpose()?,
            unit: overrides.unit.as_deref().map(unit_from_name).transpose()?,
            ground_height: overrides.ground_height,
            joints: Vec::new(),
        };
        decisions.validate()?;
        let joints = overrides.joints.iter().map(|wish| joint_wish(wish));
        Ok(Self {
            decisions,
            joints: joints.collect::<Result<_>>()?,
        })
    }

    /// The decisions about one clip: a joint is decided for every performer who has it.
    ///
    /// # Errors
    /// A joint that the clip does not have.
    pub fn decisions(&self, clip: &Clip) -> Result<Decisions> {
        let mut decisions = self.decisions.clone();
        for (role, label) in &self.joints {
            let before = decisions.joints.len();
            for (performer, owner) in clip.performers.iter().enumerate() {
                let found = owner.skeleton.labels().iter().position(|one| one == label);
                decisions.joints.extend(found.map(|joint| JointDecision {
                    performer,
                    role: *role,
                    joint,
                }));
            }
            if decisions.joints.len() == before {
                bail!("--joint: there is no joint {label}");
            }
        }
        Ok(decisions)
    }
}

fn joint_wish(wish: &str) -> Result<(Role, String)> {
    let (role, label) = wish
        .split_once('=')
        .with_context(|| format!("--joint is {wish}; expected ROLE=JOINT"))?;
    let known = Role::from_name(role).with_context(|| {
        let roles: Vec<&str> = Role::ALL.iter().map(|role| role.name()).collect();
        format!(
            "--joint: {role} is no part of the body; expected one of {}",
            roles.join(", ")
        )
    })?;
    Ok((known, label.to_owned()))
}

fn up_from_name(name: &str) -> Result<Up> {
    Up::from_name(name)
        .with_context(|| format!("--up is {name}; expected +X, -X, +Y, -Y, +Z or -Z"))
}

fn unit_from_name(name: &str) -> Result<Unit> {
    match name {
        "m" => Ok(Unit::Metre),
        "dm" => Ok(Unit::Decimetre),
        "cmu" => Ok(Unit::Cmu),
        "inch" => Ok(Unit::Inch),
        "cm" => Ok(Unit::Centimetre),
        "mm" => Ok(Unit::Millimetre),
        _ => bail!("--unit is {name}; expected m, dm, cmu, inch, cm or mm"),
    }
}

/// Reads a file in slices; its SHA-256 beside.
///
/// # Errors
/// One line that names the file, and the line and column where it cannot be read.
pub fn read(file: &InputFile) -> Result<(Clip, String)> {
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
