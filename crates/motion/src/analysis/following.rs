//! One performer's analysed frames, some at a step: its track, and on the way its mean, the feature,
//! the discontinuities and the trails, which need each frame once.

use super::trails::Trails;
use crate::body::{PRINCIPAL_JOINTS, PelvisFrame, PoseTable, TrackRun};
use crate::discontinuity;
use crate::feature::{ComparableFeature, Comparing, Hips};
use crate::note::Note;
use crate::rest;
use crate::track::PelvisTrack;

/// The frames while they are followed.
#[derive(Clone, Debug)]
pub struct Following {
    run: TrackRun,
    frame: PelvisFrame,
    /// Frames of the file × (left, right) × (x, y, z), from the pelvis joint and in its axes; empty
    /// where the body is not human.
    hips: Vec<f64>,
    comparing: Comparing,
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
    /// None without frames or a human body.
    pub comparable: Option<ComparableFeature>,
    /// Of a human body; else without meaning.
    pub trails: Trails,
}

impl Following {
    /// The frames of `table`, whose joints and hips are taken, from `first_frame` on, in the coordinates of
    /// `frame`.
    pub fn new(table: &mut PoseTable, frame: &PelvisFrame, first_frame: usize) -> Self {
        let width = 3 * table.joint_count;
        Self {
            run: TrackRun::new(table, frame, first_frame),
            frame: frame.clone(),
            hips: core::mem::take(&mut table.hips),
            sum: vec![0.0; width],
            comparing: Comparing::default(),
            steps: Vec::new(),
            trails: Trails::default(),
        }
    }

    /// Numbers that are held.
    pub fn capacity(&self) -> usize {
        self.run.capacity() + self.hips.capacity()
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
            if let (Some(hips), Ok(posture)) = (self.hips_at(frame), coordinates.try_into()) {
                self.comparing.add(posture, &hips);
            }
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

    /// The hips at a frame of the track, in its coordinates.
    fn hips_at(&self, frame: usize) -> Option<Hips> {
        let first = 6 * (self.run.first_frame() + frame);
        let mut hips: [f64; 6] = self.hips.get(first..first + 6)?.try_into().ok()?;
        self.frame.apply(&mut hips);
        let [left, right] = [0, 3].map(|first| [hips[first], hips[first + 1], hips[first + 2]]);
        Some([left, right])
    }

    /// What was found in the frames followed.
    pub fn finish(self) -> Followed {
        let is_human = self.run.frames() > 0 && !self.hips.is_empty();
        let track = self.run.finish();
        let count = track.frames().max(1) as f64;
        Followed {
            jumps: discontinuity::among(&self.steps, track.first_frame),
            comparable: is_human.then(|| self.comparing.finish()),
            trails: self.trails,
            mean: self.sum.into_iter().map(|sum| sum / count).collect(),
            track,
        }
    }
}
