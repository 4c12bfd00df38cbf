//! The command line, as clap reads it.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
use comparison::distance::{Dissimilarity, Distance};
use comparison::settings::{CutRule, Linkage, Settings};
use motion::keypose::evaluation::Span;
use motion::keypose::{Options, SelectionRule};
use motion::report::Table;

use crate::labels::{self, LabelRule};

/// Keyposes of motion capture files (BVH).
///
/// Frames count from 0 in the file. A folder stands for all .bvh files below it, in the order of
/// their names; a file that is named twice is taken once. What cannot be found or read is told on
/// standard error, the others are still done, and the exit status is 1. Results are text for a
/// person unless a form is named; docs/formats.md describes the forms.
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
    /// Tells the posture-variation feature of each file's first human performer.
    Features(Features),
    /// Compares the files of a set: distances, tree, clusters, neighbours, and scores of labels.
    ///
    /// Of each file the first human performer is compared; other files are told on standard error.
    Compare(Compare),
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

/// `keypose features`.
#[derive(Args, Debug)]
pub struct Features {
    /// Motion capture files and folders of them.
    #[arg(required = true, value_name = "FILE|DIR")]
    pub paths: Vec<PathBuf>,
    /// One JSON object a line for each file (docs/formats.md).
    #[arg(long, group = "form")]
    pub json: bool,
    /// A table with one line a file (docs/formats.md); what is written if no form is named.
    #[arg(long, group = "form")]
    pub csv: bool,
    /// The bytes of a NumPy array, files × 12.
    #[arg(long, group = "form")]
    pub npy: bool,
    /// Features of the same motion on a body of standard lengths, for comparing across rigs.
    #[arg(long)]
    pub across_rigs: bool,
    /// How files are read.
    #[command(flatten)]
    pub overrides: Overrides,
}

/// `keypose compare`.
#[derive(Args, Debug)]
pub struct Compare {
    /// Motion capture files and folders of them.
    #[arg(required = true, value_name = "FILE|DIR")]
    pub paths: Vec<PathBuf>,
    /// One JSON object with all that is known of the set (docs/formats.md).
    #[arg(long, group = "form")]
    pub json: bool,
    /// A table with one line a clip: label, cluster, nearest clip (docs/formats.md).
    #[arg(long, group = "form")]
    pub csv: bool,
    /// The tree as Newick text.
    #[arg(long, group = "form")]
    pub newick: bool,
    /// Where labels come from: `folder`, or a pattern of file names, as '{label}_*' (`*` is anything).
    #[arg(long, value_name = "folder|PATTERN", value_parser = labels::rule)]
    pub labels: Option<LabelRule>,
    /// How alike two clips are.
    #[arg(long, value_enum, default_value_t)]
    pub distance: DistanceName,
    /// A clip is as near as its mirror image; the tree is one of group averages.
    #[arg(long)]
    pub mirror: bool,
    /// Compare on a body of standard lengths.
    #[arg(long)]
    pub across_rigs: bool,
    /// How the tree is made; if not said, ward, or average with --mirror, which leaves no vectors.
    #[arg(long, value_enum)]
    pub linkage: Option<LinkageName>,
    /// How the tree is cut: into N clusters, or by a rule; if not said, bic for ward, mojena for average.
    #[arg(long, value_name = "N|bic|mojena", value_parser = cut_rule)]
    pub clusters: Option<CutRule>,
    /// How files are read.
    #[command(flatten)]
    pub overrides: Overrides,
}

/// The distances that there are.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
pub enum DistanceName {
    /// Euclidean distance of the posture variation.
    #[default]
    PostureVariation,
}

/// The ways to make a tree.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum LinkageName {
    /// Ward's method.
    Ward,
    /// Group average.
    Average,
}

fn cut_rule(text: &str) -> Result<CutRule, String> {
    match (text, text.parse()) {
        ("bic", _) => Ok(CutRule::Bic),
        ("mojena", _) => Ok(CutRule::Mojena),
        (_, Ok(clusters)) if clusters > 0 => Ok(CutRule::Number(clusters)),
        _ => Err("expected a whole number from 1, bic or mojena".to_owned()),
    }
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
    /// The height of the ground along the up axis, in the file's units of length.
    #[arg(long, value_name = "HEIGHT", allow_hyphen_values = true)]
    pub ground_height: Option<f64>,
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

impl Compare {
    /// The core's settings.
    pub fn settings(&self) -> Settings {
        let linkage = match self.linkage {
            Some(LinkageName::Ward) => Linkage::Ward,
            Some(LinkageName::Average) => Linkage::Average,
            None if self.mirror => Linkage::Average,
            None => Linkage::default(),
        };
        let DistanceName::PostureVariation = self.distance;
        Settings {
            distance: Distance::PostureVariation(Dissimilarity {
                across_rigs: self.across_rigs,
                mirror_aware: self.mirror,
            }),
            linkage,
            cut: self.clusters,
        }
    }
}

impl Features {
    /// The distance whose features are told.
    pub fn distance(&self) -> Distance {
        Distance::PostureVariation(Dissimilarity {
            across_rigs: self.across_rigs,
            mirror_aware: false,
        })
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
