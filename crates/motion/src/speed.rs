//! Motion speed: a track of pelvis coordinates in, one number a frame step out.
//!
//! Every coordinate is low-pass filtered; then
//! `v(n) = fs · sqrt( Σ_j |p_F,j(n+1) − p_F,j(n)|² )` for n = 0 … N−2, in body heights per second.
//! v(n) belongs to row n of the track, frame `first_frame + n` of the file.
//!
//! Source: Miura et al., "Adaptive Keypose Extraction from Motion Capture Data", 2014, eq. 1–3.

use crate::hodrick_prescott::{self, Columns, LaneFilter, Rows, Solution};
use crate::track::PelvisTrack;

/// Columns filtered side by side.
const LANES: usize = 8;

/// The motion speed of one track.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionSpeed {
    /// v(n) in body heights per second, one for each row of the track but the last.
    pub values: Vec<f64>,
    /// Whether the coordinates were low-pass filtered; not so where the cut-off is not below half
    /// the frame rate.
    pub filtered: bool,
}

/// The motion speed of `track`, filtered at `cutoff_hz` ([`crate::keypose::Options::low_pass_hz`]).
pub fn motion_speed(track: &PelvisTrack, frame_rate_hz: f64, cutoff_hz: f64) -> MotionSpeed {
    let mut run = SpeedRun::new(track, frame_rate_hz, cutoff_hz);
    while !run.advance(track, usize::MAX) {}
    run.finish()
}

/// The slow part of a speed, drawn beside it (default cut-off
/// [`crate::keypose::Options::trend_hz`]).
pub fn trend(speed: &[f64], frame_rate_hz: f64, cutoff_hz: f64) -> Vec<f64> {
    hodrick_prescott::low_pass(speed, cutoff_hz, frame_rate_hz)
}

/// The computation of a motion speed, cut into steps.
#[derive(Clone, Debug)]
pub struct SpeedRun {
    frame_rate_hz: f64,
    width: usize,
    /// None: the coordinates are used as they are.
    filter: Option<LaneFilter<LANES>>,
    solution: Solution<LANES>,
    first_column: usize,
    /// Σ of the squared steps of the columns done so far, one a frame step.
    squares: Vec<f64>,
}

impl SpeedRun {
    /// Makes ready for `track`.
    pub fn new(track: &PelvisTrack, frame_rate_hz: f64, cutoff_hz: f64) -> Self {
        let filter = (cutoff_hz < frame_rate_hz / 2.0).then(|| {
            let lambda = hodrick_prescott::lambda_of_cutoff(cutoff_hz, frame_rate_hz);
            LaneFilter::new(track.frames(), [lambda; LANES])
        });
        let mut run = Self {
            frame_rate_hz,
            width: 3 * track.joint_count,
            filter,
            solution: Solution::default(),
            first_column: 0,
            squares: vec![0.0; track.frames().saturating_sub(1)],
        };
        run.start_columns();
        run
    }

    /// Works for about `budget` rows of eight columns; always with the track of
    /// [`SpeedRun::new`]. True when done.
    pub fn advance(&mut self, track: &PelvisTrack, budget: usize) -> bool {
        if self.first_column >= self.width {
            return true;
        }
        let columns = Columns {
            values: &track.coordinates,
            width: self.width,
            first: self.first_column,
        };
        let Some(filter) = &self.filter else {
            add_squared_steps(&mut self.squares, |n| columns.row(n));
            self.first_column += LANES;
            return self.first_column >= self.width;
        };
        if filter.advance(&columns, &mut self.solution, budget) {
            let rows = self.solution.rows();
            add_squared_steps(&mut self.squares, |n| rows[n]);
            self.first_column += LANES;
            self.start_columns();
        }
        self.first_column >= self.width
    }

    /// The part done, from 0 to 1.
    pub fn progress(&self) -> f64 {
        match self.width {
            0 => 1.0,
            width => self.first_column.min(width) as f64 / width as f64,
        }
    }

    /// The speed, once [`SpeedRun::advance`] has said true.
    pub fn finish(mut self) -> MotionSpeed {
        for value in &mut self.squares {
            *value = self.frame_rate_hz * value.sqrt();
        }
        MotionSpeed {
            values: self.squares,
            filtered: self.filter.is_some(),
        }
    }

    fn start_columns(&mut self) {
        if let Some(filter) = &self.filter {
            filter.start(&mut self.solution);
        }
    }
}

fn add_squared_steps(squares: &mut [f64], row: impl Fn(usize) -> [f64; LANES]) {
    if squares.is_empty() {
        return;
    }
    let mut last = row(0);
    for (n, square) in squares.iter_mut().enumerate() {
        let next = row(n + 1);
        for lane in 0..LANES {
            let step = next[lane] - last[lane];
            *square += step * step;
        }
        last = next;
    }
}
