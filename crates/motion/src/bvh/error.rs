//! The one error of a file that cannot be read: what was found, what was expected, what to do.

use core::fmt;

use super::place::Place;
use crate::note::{fill, sentence_kinds};

sentence_kinds! {
    /// What makes a file unreadable.
    ErrorKind:
    Empty "empty" "The file is empty; a BVH file begins with HIERARCHY. Export the motion again.";
    NotBvh "not-bvh" "Found “{0}” where HIERARCHY was expected; without the skeleton the numbers have no meaning. Choose a BVH file, or export the motion again with its hierarchy.";
    NoRoot "no-root" "Found the end of the hierarchy where a ROOT was expected. Export the motion again with its skeleton.";
    ExpectedBrace "expected-brace" "Found “{0}” where “{” was expected for {1}. Put the brace there.";
    JointOutsideRoot "joint-outside-root" "Found {0} outside of any ROOT; every joint belongs to one. Look for a closing brace too many above.";
    ShortOffset "short-offset" "The OFFSET of {0} has {1} numbers, 3 were expected. Write x, y and z.";
    NoChannels "no-channels" "Found a row of numbers, but no joint has CHANNELS. Add them, or export the motion again.";
    NotANumber "not-a-number" "Found “{0}” where a number was expected. Correct or remove it.";
    ShortRow "short-row" "Found {0} values in this row where {1} were expected, one for each channel. Complete the row, or export the motion again.";
    LongRow "long-row" "Found a further value in this row after the {0} that were expected, one for each channel. Remove what is too much, or export the motion again.";
    TextBetweenRows "text-between-rows" "Found “{0}” between two rows of numbers. Remove it.";
    MixedDecimalMarks "mixed-decimal-marks" "Found “{0}”, but the file writes numbers with a decimal {1} elsewhere. Use one of them throughout.";
    TooManyJoints "too-many-joints" "The file has more than {0} joints, the limit. Remove joints that are not needed.";
    LongHierarchy "long-hierarchy" "The hierarchy is longer than {0} bytes, the limit. Check that this is a BVH file.";
    TooManyValues "too-many-values" "The file has more than {0} values, the limit. Cut it into shorter motions.";
    OutOfMemory "out-of-memory" "The memory does not suffice for {0} more values. Close other motions, or cut this one into shorter ones.";
}

/// Why a file cannot be read, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ParseError {
    /// What is wrong.
    pub kind: ErrorKind,
    /// The line of the file, from 1.
    pub line: usize,
    /// The column, from 1, in characters.
    pub column: usize,
    /// What the template's `{0}`, `{1}` … stand for.
    pub details: Vec<String>,
}

impl ParseError {
    /// An error at a place.
    pub fn new(kind: ErrorKind, at: Place, details: Vec<String>) -> Self {
        Self {
            kind,
            line: at.line,
            column: at.column,
            details,
        }
    }

    /// The English sentence, without the place.
    pub fn message(&self) -> String {
        fill(self.kind.template(), &self.details)
    }
}

impl fmt::Display for ParseError {
    /// The sentence alone; the place goes before it as the one who prints likes.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.message())
    }
}

impl core::error::Error for ParseError {}

/// What of a text is shown in a message: its beginning, without control characters.
pub fn excerpt(text: &str) -> String {
    const LONGEST: usize = 40;
    let clean = |c: char| if c.is_control() { ' ' } else { c };
    let mut shown: String = text.trim().chars().take(LONGEST).map(clean).collect();
    if text.trim().chars().nth(LONGEST).is_some() {
        shown.push('…');
    }
    shown
}
