//! One file's motion: performers, rows of values, and the notes of its reading.

use crate::note::Note;
use crate::skeleton::Skeleton;

/// One performer of a clip and where its values lie in a row.
#[derive(Clone, Debug, PartialEq)]
pub struct Performer {
    /// The performer's joints.
    pub skeleton: Skeleton,
    /// The column of the performer's first channel in a row.
    pub first_column: usize,
}

/// A motion as read from one file.
#[derive(Clone, Debug, PartialEq)]
pub struct Clip {
    /// One for each ROOT, in the order of the file; at least one.
    pub performers: Vec<Performer>,
    /// Frames × `row_width` values as in the file: positions in file units, rotations in
    /// degrees; finite.
    pub values: Vec<f64>,
    /// Values of all performers in one frame.
    pub row_width: usize,
    /// Frames of every performer.
    pub frames: usize,
    /// Seconds from one frame to the next; positive and finite.
    pub frame_time_s: f64,
    /// What was found and assumed while reading, in the order of the file.
    pub notes: Vec<Note>,
}

impl Clip {
    /// Frames per second.
    pub fn frame_rate_hz(&self) -> f64 {
        1.0 / self.frame_time_s
    }

    /// The values of one performer at one frame (both from 0), in the order of its channels.
    pub fn frame_values(&self, performer: usize, frame: usize) -> &[f64] {
        let owner = &self.performers[performer];
        let start = frame * self.row_width + owner.first_column;
        &self.values[start..start + owner.skeleton.channel_count()]
    }
}
