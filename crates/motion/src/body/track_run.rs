//! The track while it is made: a complete pose table goes in, pelvis coordinates come out, some
//! frames at a step and in the table's own memory.

use super::{PelvisFrame, PoseTable};
use crate::track::PelvisTrack;

/// Turns the frames of a table into pelvis coordinates.
#[derive(Clone, Debug)]
pub struct TrackRun {
    /// Coordinates as far as `done`, then what is left of the table.
    coordinates: Vec<f64>,
    frame: PelvisFrame,
    joint_count: usize,
    first_frame: usize,
    frames: usize,
    done: usize,
}

impl TrackRun {
    /// A run over the frames from `first_frame` on, which takes the joints of `table`.
    pub fn new(table: &mut PoseTable, frame: &PelvisFrame, first_frame: usize) -> Self {
        let first_frame = first_frame.min(table.frames());
        Self {
            frames: table.frames() - first_frame,
            joint_count: table.joint_count,
            coordinates: core::mem::take(&mut table.joints),
            frame: frame.clone(),
            first_frame,
            done: 0,
        }
    }

    /// Frames that there will be, those from `first_frame` on.
    pub fn frames(&self) -> usize {
        self.frames
    }

    /// The frame of the table that the first frame of the track is.
    pub fn first_frame(&self) -> usize {
        self.first_frame
    }

    /// Numbers that are held.
    pub fn capacity(&self) -> usize {
        self.coordinates.capacity()
    }

    /// Frames that are done.
    pub fn done(&self) -> usize {
        self.done
    }

    /// Does at most `frames` frames more; says whether all are done.
    pub fn advance(&mut self, frames: usize) -> bool {
        let width = 3 * self.joint_count;
        let end = self.done + frames.min(self.frames - self.done);
        let (from, to) = (self.first_frame * width, self.done * width..end * width);
        self.coordinates
            .copy_within(from + to.start..from + to.end, to.start);
        self.frame.apply(&mut self.coordinates[to]);
        self.done = end;
        self.done == self.frames
    }

    /// The coordinates of a frame that is done, counted from `first_frame`.
    pub fn frame(&self, frame: usize) -> &[f64] {
        let width = 3 * self.joint_count;
        &self.coordinates[frame * width..(frame + 1) * width]
    }

    /// The track of the frames done.
    pub fn finish(mut self) -> PelvisTrack {
        self.coordinates.truncate(self.done * 3 * self.joint_count);
        PelvisTrack {
            coordinates: self.coordinates,
            joint_count: self.joint_count,
            first_frame: self.first_frame,
        }
    }
}
