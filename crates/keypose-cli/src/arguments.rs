//! The command line, as clap reads it.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};
use motion::keypose::evaluation::Span;
use motion::keypose::{Options, SelectionRule};
use motion::report::Table;

/// Keyposes of motion capture files (BVH).
///
/// Frames count from 0 in the file. A folder stands for all .bvh files below it, in the order of
/// their names. Files that cannot be read are told on standard error, the others are still done,
/// and the exit status is 1.
#[derive(Debug, Parser)]
#[command(name = "keypose", version)]
pub struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
    /// Files worked on at the same time; 0 = one for each processor. The output is the same.
    #[arg(long, global = true, default_value_t = 0, value_name = "N")]
    pub threads: usize,
}

/// What the command does.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Tells what is in each file: performers, body, up axis, leading rest frames, notes.
    Inspect(Inspect),
    /// Finds the keyposes of each file.
    Keyposes(Keyposes),
    /// Writes the sample motions into a folder, each with its true keyposes.
    Samples(Samples),
}

/// `keypose inspect`.
#[derive(Args, Debug)]
pub struct Inspect {
    /// Motion capture files and folders of them.
    #[arg(required = true, value_name = "FILE|DIR")]
    pub paths: Vec<PathBuf>,
    /// How files are read.
    #[command(flatten)]
    pub overrides: Overrides,
}

/// `keypose keyposes`.
#[derive(Args, Debug)]
pub struct Keyposes {
    /// Motion capture files and folders of them.
    #[arg(required = true, value_name = "FILE|DIR")]
    pub paths: Vec<PathBuf>,
    /// One JSON object a line for each file and performer (docs/formats.md).
    #[arg(long, group = "form")]
    pub json: bool,
    /// A table with one line a keypose (docs/formats.md).
    #[arg(long, group = "form")]
    pub csv: bool,
    /// List every candidate instead of the keyposes.
    #[arg(long, requires = "form", conflicts_with_all = ["traces", "marks"])]
    pub candidates: bool,
    /// List every candidate's way through the time scales instead of the keyposes.
    #[arg(long, requires = "form", conflicts_with = "marks")]
    pub traces: bool,
    /// True keyposes to compare with: a JSON file, or a folder of them, matched by `file`.
    #[arg(long, value_name = "FILE|DIR")]
    pub marks: Option<PathBuf>,
    /// Judge only keyposes within the span that the marks cover (and a quarter interval around).
    #[arg(long, requires = "marks")]
    pub within_marks: bool,
    /// How files are read.
    #[command(flatten)]
    pub overrides: Overrides,
    /// The method's parameters.
    #[command(flatten)]
    pub method: Method,
}

/// `keypose samples`.
#[derive(Args, Debug)]
pub struct Samples {
    /// The folder, made where it does not exist.
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
    /// Which samples; all if none is named.
    #[arg(value_name = "ID")]
    pub ids: Vec<String>,
}

/// What a person decides about all files of the call; otherwise it is found in each.
#[derive(Args, Clone, Debug, Default)]
pub struct Overrides {
    /// Frames per second, instead of what the file says.
    #[arg(long, value_name = "HZ")]
    pub frame_rate_hz: Option<f64>,
    /// Leading frames to leave out, instead of the leading rest pose found.
    #[arg(long, value_name = "N")]
    pub leading_rest_frames: Option<usize>,
    /// The up axis: +X, -X, +Y, -Y, +Z or -Z.
    #[arg(long, value_name = "AXIS", allow_hyphen_values = true)]
    pub up: Option<String>,
    /// The unit of length: m, dm, cmu, inch, cm or mm.
    #[arg(long, value_name = "UNIT")]
    pub unit: Option<String>,
    /// A joint of the file that stands for a part of the body, e.g. left_wrist=LeftHand; can be
    /// given more than once.
    #[arg(long = "joint", value_name = "ROLE=JOINT")]
    pub joints: Vec<String>,
}

/// The method's parameters; each default is the method's own.
#[derive(Args, Clone, Debug)]
pub struct Method {
    /// Select by the paper's rule to the letter.
    #[arg(long, conflicts_with = "even_split")]
    pub literal: bool,
    /// Select by the two-class split with the least squares within.
    #[arg(long)]
    pub even_split: bool,
    /// Cut-off of the low-pass filter before the speed, in Hz.
    #[arg(long, value_name = "HZ", default_value_t = Options::default().low_pass_hz)]
    pub low_pass_hz: f64,
    /// The finest time scale, in Hz.
    #[arg(long, value_name = "HZ", default_value_t = Options::default().scale_max_hz)]
    pub scale_max_hz: f64,
    /// No time scale below this, in Hz.
    #[arg(long, value_name = "HZ", default_value_t = Options::default().scale_min_hz)]
    pub scale_min_hz: f64,
    /// Ratio of a time scale to the one before.
    #[arg(long, value_name = "RATIO", default_value_t = Options::default().scale_ratio)]
    pub scale_ratio: f64,
    /// Minima shallower than this part of the greatest speed do not count.
    #[arg(long, value_name = "PART", default_value_t = Options::default().depth_floor)]
    pub depth_floor: f64,
    /// Standard deviations above the mean merge height at which merging ends.
    #[arg(long, value_name = "K", default_value_t = Options::default().mojena_k)]
    pub mojena_k: f64,
}

impl Keyposes {
    /// What is listed.
    pub fn table(&self) -> Table {
        match (self.candidates, self.traces) {
            (true, _) => Table::Candidates,
            (_, true) => Table::Traces,
            _ => Table::Keyposes,
        }
    }

    /// Which keyposes are judged.
    pub fn span(&self) -> Span {
        match self.within_marks {
            true => Span::Marks,
            false => Span::Clip,
        }
    }
}

impl Method {
    /// The core's options.
    pub fn options(&self) -> Options {
        Options {
            low_pass_hz: self.low_pass_hz,
            scale_max_hz: self.scale_max_hz,
            scale_min_hz: self.scale_min_hz,
            scale_ratio: self.scale_ratio,
            depth_floor: self.depth_floor,
            mojena_k: self.mojena_k,
            selection: self.selection(),
            ..Options::default()
        }
    }

    fn selection(&self) -> SelectionRule {
        match (self.literal, self.even_split) {
            (true, _) => SelectionRule::Literal,
            (_, true) => SelectionRule::EvenSplit,
            _ => SelectionRule::Automatic,
        }
    }
}
