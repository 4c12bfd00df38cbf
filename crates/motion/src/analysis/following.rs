//! One performer's analysed frames, some at a step: its track, and on the way its mean, the feature,
//! the discontinuities and the trails, which need each frame once.

use super::trails::Trails;
use crate::body::{PRINCIPAL_JOINTS, PelvisFrame, PoseTable, TrackRun};
use crate::discontinuity;
use crate::feature::PostureVariation;
use crate::note::Note;
use crate::rest;
use crate::track::PelvisTrack;

/// The frames while they are followed.
#[derive(Clone, Debug)]
pub struct Following {
    run: TrackRun,
    variation: PostureVariation,
    steps: Vec<f64>,
    /// The sum of the coordinates.
    sum: Vec<f64>,
    trails: Trails,
}

/// What following the frames gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Followed {
    pub track: PelvisTrack,
    /// The mean over its frames.
    pub mean: Vec<f64>,
    pub jumps: Vec<Note>,
    /// None without frames.
    pub feature: Option<[f64; 12]>,
    /// Of a human body; else without meaning.
    pub trails: Trails,
}

impl Following {
    /// The frames of `table`, whose joints are taken, from `first_frame` on, in the coordinates of
    /// `frame`.
    pub fn new(table: &mut PoseTable, frame: &PelvisFrame, first_frame: usize) -> Self {
        let width = 3 * table.joint_count;
        Self {
            run: TrackRun::new(table, frame, first_frame),
            sum: vec![0.0; width],
            variation: PostureVariation::default(),
            steps: Vec::new(),
            trails: Trails::default(),
        }
    }

    /// Numbers that are held.
    pub fn capacity(&self) -> usize {
        self.run.capacity()
    }

    /// The part done, from 0 to 1.
    pub fn progress(&self) -> f64 {
        self.run.done() as f64 / self.run.frames().max(1) as f64
    }

    /// Follows at most `frames` frames more; says whether all are done.
    pub fn advance(&mut self, frames: usize) -> bool {
        let first = self.run.done();
        let is_complete = self.run.advance(frames);
        for frame in first..self.run.done() {
            let coordinates = self.run.frame(frame);
            self.variation.add(coordinates);
            for (sum, value) in self.sum.iter_mut().zip(coordinates) {
                *sum += value;
            }
            if frame > 0 {
                let (before, now) = (self.run.frame(frame - 1), self.run.frame(frame));
                self.steps.push(rest::step_between(before, now));
                if now.len() >= 3 * PRINCIPAL_JOINTS {
                    self.trails.add(before, now);
                }
            }
        }
        is_complete
    }

    /// What was found in the frames followed.
    pub fn finish(self) -> Followed {
        let track = self.run.finish();
        let count = track.frames().max(1) as f64;
        Followed {
            jumps: discontinuity::among(&self.steps, track.first_frame),
            feature: (track.frames() > 0).then(|| self.variation.feature()),
            trails: self.trails,
            mean: self.sum.into_iter().map(|sum| sum / count).collect(),
            track,
        }
    }
}
