//! Motion speed: a track of pelvis coordinates in, one number a frame step out.
//!
//! Every coordinate is low-pass filtered; then
//! `v(n) = fs · sqrt( Σ_j |p_F,j(n+1) − p_F,j(n)|² )` for n = 0 … N−2, in body heights per second.
//! v(n) belongs to row n of the track, frame `first_frame + n` of the file.
//!
//! Source: Miura et al., "Adaptive Keypose Extraction from Motion Capture Data", 2014, eq. 1–3.

use crate::body::{BODY_PARTS, BodyPart, PRINCIPAL_JOINTS};
use crate::hodrick_prescott::{self, LaneFilter, Solution};
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
    /// The speed of each part of the body ([`BodyPart::ALL`]), by the same formula over its own
    /// joints; empty unless asked for.
    pub parts: Vec<[f64; BODY_PARTS]>,
}

/// The motion speed of `track`, filtered at `cutoff_hz` ([`crate::keypose::Options::low_pass_hz`]).
pub fn motion_speed(track: &PelvisTrack, frame_rate_hz: f64, cutoff_hz: f64) -> MotionSpeed {
    let mut run = SpeedRun::new(track, frame_rate_hz, cutoff_hz);
    while !run.advance(track, usize::MAX) {}
    run.finish()
}

/// What is done with eight columns, and from which row on.
#[derive(Clone, Copy, Debug)]
enum Stage {
    Gather(usize),
    Filter,
    Add(usize),
    /// After the last columns: from squares to speeds.
    Root(usize),
    Done,
}

/// The computation of a motion speed, cut into steps.
#[derive(Clone, Debug)]
pub struct SpeedRun {
    frame_rate_hz: f64,
    /// Columns of the track.
    width: usize,
    /// None: the coordinates are used as they are.
    filter: Option<LaneFilter<LANES>>,
    solution: Solution<LANES>,
    first_column: usize,
    stage: Stage,
    /// The columns in work, gathered from the track; those beyond its width are zero.
    columns: Vec<[f64; LANES]>,
    /// Σ of the squared steps of the columns done so far, one a frame step.
    squares: Vec<f64>,
    /// The same by part of the body; empty unless asked for.
    part_squares: Vec<[f64; BODY_PARTS]>,
}

impl SpeedRun {
    /// Makes ready for `track`.
    pub fn new(track: &PelvisTrack, frame_rate_hz: f64, cutoff_hz: f64) -> Self {
        let filter = (cutoff_hz < frame_rate_hz / 2.0).then(|| {
            let lambda = hodrick_prescott::lambda_of_cutoff(cutoff_hz, frame_rate_hz);
            LaneFilter::new(track.frames(), [lambda; LANES])
        });
        Self {
            frame_rate_hz,
            width: 3 * track.joint_count,
            filter,
            solution: Solution::default(),
            first_column: 0,
            stage: match track.frames() {
                0 | 1 => Stage::Done,
                _ => Stage::Gather(0),
            },
            columns: Vec::with_capacity(track.frames()),
            squares: vec![0.0; track.frames().saturating_sub(1)],
            part_squares: Vec::new(),
        }
    }

    /// The same run, to give the speed of each part of the body too; for a track of the principal
    /// joints of a human body alone, before the first step.
    #[must_use]
    pub fn with_parts(mut self) -> Self {
        self.part_squares = vec![[0.0; BODY_PARTS]; self.squares.len()];
        self
    }

    /// Works for `budget` rows of eight columns: they are gathered, filtered in three passes, and
    /// their steps added. Always with the track of [`SpeedRun::new`]. True when done.
    pub fn advance(&mut self, track: &PelvisTrack, budget: usize) -> bool {
        if self.is_done() {
            return true;
        }
        match self.stage {
            Stage::Gather(row) => self.gather(track, row, budget),
            Stage::Filter => self.filter(budget),
            Stage::Add(step) => self.add_squared_steps(step, budget),
            Stage::Root(step) => self.take_roots(step, budget),
            Stage::Done => {}
        }
        self.is_done()
    }

    /// The part done, from 0 to 1.
    pub fn progress(&self) -> f64 {
        match self.is_done() {
            true => 1.0,
            false => self.first_column as f64 / (self.width + LANES) as f64,
        }
    }

    /// The speed, once [`SpeedRun::advance`] has said true.
    pub fn finish(self) -> MotionSpeed {
        MotionSpeed {
            values: self.squares,
            filtered: self.filter.is_some(),
            parts: self.part_squares,
        }
    }

    fn is_done(&self) -> bool {
        matches!(self.stage, Stage::Done)
    }

    /// Gathers the next columns: side by side in memory they are filtered several times as fast.
    fn gather(&mut self, track: &PelvisTrack, row: usize, budget: usize) {
        if row == 0 {
            self.columns.clear();
        }
        let used = LANES.min(self.width - self.first_column);
        let frames = track.coordinates.chunks_exact(self.width);
        let end = row.saturating_add(budget).min(track.frames());
        for frame in frames.skip(row).take(end - row) {
            let mut lanes = [0.0; LANES];
            lanes[..used].copy_from_slice(&frame[self.first_column..self.first_column + used]);
            self.columns.push(lanes);
        }
        self.stage = Stage::Gather(end);
        if end == track.frames() {
            if let Some(filter) = &self.filter {
                filter.start(&mut self.solution);
            }
            self.stage = Stage::Filter;
        }
    }

    fn filter(&mut self, budget: usize) {
        let is_filtered = match &self.filter {
            Some(filter) => filter.advance(&self.columns, &mut self.solution, budget),
            None => true,
        };
        if is_filtered {
            self.stage = Stage::Add(0);
        }
    }

    fn add_squared_steps(&mut self, first: usize, budget: usize) {
        let rows = match &self.filter {
            Some(_) => self.solution.rows(),
            None => &self.columns,
        };
        let end = first.saturating_add(budget).min(self.squares.len());
        let pairs = || rows[first..=end].windows(2);
        for (square, pair) in self.squares[first..end].iter_mut().zip(pairs()) {
            for (next, last) in pair[1].iter().zip(&pair[0]) {
                let step = next - last;
                *square += step * step;
            }
        }
        let part_of_lane = part_of_lane(self.first_column);
        for (squares, pair) in self.part_squares.iter_mut().skip(first).zip(pairs()) {
            for (lane, part) in part_of_lane.iter().enumerate() {
                let step = pair[1][lane] - pair[0][lane];
                squares[*part] += step * step;
            }
        }
        self.stage = Stage::Add(end);
        if end == self.squares.len() {
            self.first_column += LANES;
            self.stage = match self.first_column < self.width {
                true => Stage::Gather(0),
                false => Stage::Root(0),
            };
        }
    }

    fn take_roots(&mut self, first: usize, budget: usize) {
        let end = first.saturating_add(budget).min(self.squares.len());
        let parts = self.part_squares.iter_mut().skip(first).take(end - first);
        for value in self.squares[first..end].iter_mut().chain(parts.flatten()) {
            *value = self.frame_rate_hz * value.sqrt();
        }
        self.stage = match end == self.squares.len() {
            true => Stage::Done,
            false => Stage::Root(end),
        };
    }
}

/// The part of the body of each of the columns from `first_column` on.
fn part_of_lane(first_column: usize) -> [usize; LANES] {
    core::array::from_fn(|lane| {
        let joint = (first_column + lane) / 3;
        BodyPart::OF_PRINCIPAL[joint.min(PRINCIPAL_JOINTS - 1)].index()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hodrick_prescott::low_pass;
    use test_support::Random;

    fn random_track(frames: usize, joint_count: usize) -> PelvisTrack {
        let mut random = Random::new(frames as u64);
        let coordinates = (0..frames * joint_count * 3)
            .map(|_| random.unit())
            .collect();
        PelvisTrack {
            coordinates,
            joint_count,
            first_frame: 0,
        }
    }

    /// Column by column, as the definition says.
    fn speed_by_definition(track: &PelvisTrack, rate_hz: f64, cutoff_hz: f64) -> Vec<f64> {
        let width = 3 * track.joint_count;
        let mut squares = vec![0.0; track.frames() - 1];
        for column in 0..width {
            let values: Vec<f64> = track
                .coordinates
                .iter()
                .skip(column)
                .step_by(width)
                .copied()
                .collect();
            let filtered = low_pass(&values, cutoff_hz, rate_hz);
            for (square, pair) in squares.iter_mut().zip(filtered.windows(2)) {
                *square += (pair[1] - pair[0]) * (pair[1] - pair[0]);
            }
        }
        squares
            .iter()
            .map(|square: &f64| rate_hz * square.sqrt())
            .collect()
    }

    #[test]
    fn equals_the_definition_to_the_bit_for_any_number_of_joints() {
        for (frames, joints) in [(2, 16), (3, 16), (200, 16), (50, 1), (50, 7), (50, 31)] {
            let track = random_track(frames, joints);
            let speed = motion_speed(&track, 120.0, 10.0);
            assert!(speed.filtered);
            assert_eq!(speed.values, speed_by_definition(&track, 120.0, 10.0));
        }
    }

    #[test]
    fn a_cut_off_at_half_the_rate_leaves_the_filter_out() {
        let coordinates = vec![0.0, 0.0, 0.0, 3.0, 4.0, 0.0, 3.0, 4.0, 0.5];
        let track = PelvisTrack {
            coordinates,
            joint_count: 1,
            first_frame: 2,
        };
        let speed = motion_speed(&track, 20.0, 10.0);
        assert_eq!(
            speed,
            MotionSpeed {
                values: vec![100.0, 10.0],
                filtered: false,
                parts: Vec::new(),
            }
        );
    }

    #[test]
    fn steps_do_not_change_a_bit() {
        let track = random_track(100, 16);
        let mut run = SpeedRun::new(&track, 60.0, 10.0);
        while !run.advance(&track, 7) {
            assert!(run.progress() < 1.0);
        }
        assert_eq!(run.progress(), 1.0);
        assert_eq!(run.finish(), motion_speed(&track, 60.0, 10.0));
    }

    #[test]
    fn a_part_has_the_speed_of_its_own_joints() {
        let track = random_track(60, PRINCIPAL_JOINTS);
        let mut run = SpeedRun::new(&track, 120.0, 10.0).with_parts();
        while !run.advance(&track, 100) {}
        let speed = run.finish();
        assert_eq!(speed.values, motion_speed(&track, 120.0, 10.0).values);
        for part in BodyPart::ALL {
            let joints = BodyPart::OF_PRINCIPAL.iter().enumerate();
            let joints: Vec<usize> = joints
                .filter_map(|(joint, of)| (*of == part).then_some(joint))
                .collect();
            let frames = (0..track.frames()).map(|frame| track.frame(frame));
            let of_part = frames.flat_map(|row| {
                joints
                    .iter()
                    .flat_map(|joint| &row[3 * joint..3 * joint + 3])
            });
            let alone = PelvisTrack {
                coordinates: of_part.copied().collect(),
                joint_count: joints.len(),
                first_frame: 0,
            };
            let found: Vec<f64> = speed.parts.iter().map(|row| row[part.index()]).collect();
            assert_eq!(
                found,
                speed_by_definition(&alone, 120.0, 10.0),
                "{}",
                part.name()
            );
        }
    }

    #[test]
    fn too_short_a_track_has_no_speed() {
        for (frames, joints) in [(0, 16), (1, 16), (0, 0)] {
            let speed = motion_speed(&random_track(frames, joints), 120.0, 10.0);
            assert_eq!(speed.values, [0.0; 0]);
        }
    }
}
