//! Dynamic time warping: the postures of two clips in; how the one runs along the other, and how far
//! apart they are on the way, out.
//!
//! The local distance d(i, j) is the mean over the joints of their Euclidean distance, in body heights.
//! With the symmetric steps of Sakoe and Chiba (1978, P = 0)
//! `g(i, j) = min(g(i−1, j) + d, g(i, j−1) + d, g(i−1, j−1) + 2 d)`, `g(0, 0) = 2 d(0, 0)`, every path
//! from corner to corner weighs N + M, and the distance is `g(N−1, M−1) / (N + M)`. Of equal steps the
//! diagonal one is taken, then that of the first clip.
//!
//! A step of the path takes two bits, so that 10 000 by 10 000 frames need 25 MB.

mod band;
mod postures;
mod steps;

pub use postures::mirror_postures;

use crate::feature::{PART_OF_JOINT, PARTS};
use band::Band;
use core::ops::Range;
use postures::{Blocks, LANES, Posture, joint_distances, split};
use steps::{Step, Steps};

/// The most pairs of frames (inside the band) that are compared: 67 MB of steps.
pub const MOST_CELLS: usize = 1 << 28;

/// Rows whose local distances are made at once, so that a frame is fetched once for all of them, …
const STRIP: usize = 8;

/// … unless they hold more pairs of frames than this.
const MOST_CELLS_OF_A_STRIP: usize = 1 << 17;

/// Pairs of frames that are compared four at a time, in the time in which the parts of one pair are
/// measured.
const CELLS_OF_A_PAIR: usize = 16;

/// The part of the work that is done when the last row is, about.
const ROWS: f64 = 0.95;

/// The quantile of the parts' distances that is drawn in full colour.
const FULL_COLOUR: f64 = 0.985;

/// How two motions run along each other.
#[derive(Clone, Debug, PartialEq)]
pub struct Warped {
    /// The distance along the path, in body heights.
    pub distance: f64,
    /// For each step of the path the frame of the first clip, from 0.
    pub path_a: Vec<usize>,
    /// The frame of the second one.
    pub path_b: Vec<usize>,
    /// How far the first clip is ahead: b / (N_B − 1) − a / (N_A − 1); a single frame is at 0.
    pub ahead: Vec<f64>,
    /// The mean distance of the joints of each part of the body, in body heights.
    pub part_distances: Vec<[f64; PARTS]>,
    /// Their 98.5th percentile.
    pub full_colour: f64,
}

/// Why two clips cannot be warped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WarpingError {
    /// A clip has no frame.
    NoFrames,
    /// Too long for each other without a narrower band.
    TooManyCells {
        /// Pairs of frames inside the band.
        cells: usize,
        /// [`MOST_CELLS`].
        most: usize,
    },
}

/// A warping in pieces, so that other work can go on between them and it can be given up.
#[derive(Clone, Debug)]
pub struct Warping {
    a: Vec<Posture>,
    b: Blocks,
    band: Band,
    steps: Steps,
    row: usize,
    /// g of the row before and of the present one, each behind a column that is never reached.
    before: Vec<f64>,
    present: Vec<f64>,
    /// Local distances of a strip, row by row.
    strip: Vec<f64>,
    /// The frames of both clips along the path, from its end.
    path: Vec<(usize, usize)>,
    /// What is measured along it, from its end.
    part_distances: Vec<[f64; PARTS]>,
}

impl Warping {
    /// Warps `b` onto `a`: frames × joints × (x, y, z) in pelvis coordinates. A pair of frames is looked
    /// at only if `|j − i (M−1)/(N−1)| ≤ max(band, (M−1)/(N−1), 1)`, which always leaves a path; any
    /// without a band.
    ///
    /// # Errors
    /// Clips without a frame, or so long that the steps would not fit.
    pub fn new(a: &[f64], b: &[f64], band: Option<usize>) -> Result<Self, WarpingError> {
        let (a, b) = (split(a), Blocks::new(&split(b)));
        if a.is_empty() || b.frames == 0 {
            return Err(WarpingError::NoFrames);
        }
        let band = Band::new(a.len(), b.frames, band);
        let (cells, most) = (band.cells(), MOST_CELLS);
        if cells > most {
            return Err(WarpingError::TooManyCells { cells, most });
        }
        let mut before = vec![f64::INFINITY; b.frames + 1];
        // The path comes from nowhere at no cost.
        before[0] = 0.0;
        Ok(Self {
            present: vec![f64::INFINITY; b.frames + 1],
            before,
            steps: Steps::new(&band),
            strip: Vec::new(),
            path: Vec::new(),
            part_distances: Vec::new(),
            row: 0,
            a,
            b,
            band,
        })
    }

    /// Does about `cells` pairs of frames more; returns the part done, 1 when only [`Self::finish`] is
    /// left.
    pub fn step(&mut self, cells: usize) -> f64 {
        let mut done = 0;
        while self.row < self.a.len() {
            if done >= cells {
                return ROWS * self.row as f64 / self.a.len() as f64;
            }
            done += self.strip();
        }
        let left = cells.saturating_sub(done);
        let along = self.walk(left) + self.measure(left);
        // A path is that long at most.
        let longest = self.a.len() + self.b.frames;
        match self.part_distances.len() == self.path.len() && self.path.last() == Some(&(0, 0)) {
            true => 1.0,
            false => ROWS + (1.0 - ROWS) * along as f64 / (2 * longest) as f64,
        }
    }

    /// The path and what is told along it; does what is left to do.
    pub fn finish(mut self) -> Warped {
        while self.step(usize::MAX) < 1.0 {}
        self.path.reverse();
        self.part_distances.reverse();
        let (rows, columns) = (self.a.len(), self.b.frames);
        let at = |frame: usize, frames: usize| frame as f64 / (frames - 1).max(1) as f64;
        let path = self.path.iter();
        Warped {
            // The last row is the one before the next.
            distance: self.before[columns] / (rows + columns) as f64,
            ahead: path.map(|(a, b)| at(*b, columns) - at(*a, rows)).collect(),
            full_colour: quantile(self.part_distances.as_flattened().to_vec(), FULL_COLOUR),
            part_distances: self.part_distances,
            path_a: self.path.iter().map(|(a, _)| *a).collect(),
            path_b: self.path.iter().map(|(_, b)| *b).collect(),
        }
    }

    /// Does a strip of rows; returns how many pairs of frames that were.
    fn strip(&mut self) -> usize {
        let width = |rows: &Range<usize>| {
            // The band only ever moves on.
            let first = self.band.row(rows.start).start / LANES;
            let last = self.band.row(rows.end - 1).end.div_ceil(LANES);
            first..last
        };
        let one = self.row..self.row + 1;
        let height = MOST_CELLS_OF_A_STRIP / (LANES * width(&one).len());
        let rows = self.row..self.a.len().min(self.row + height.clamp(1, STRIP));
        let blocks = width(&rows);
        let width = blocks.len() * LANES;
        let mut strip = core::mem::take(&mut self.strip);
        strip.resize(rows.len() * width, 0.0);
        self.b
            .distances(&self.a[rows.clone()], blocks.clone(), &mut strip);
        for (row, distances) in rows.zip(strip.chunks_exact(width)) {
            self.accumulate(row, distances, blocks.start * LANES);
        }
        self.strip = strip;
        self.strip.len()
    }

    /// One row of g, from the local distances of the columns from `first` on.
    fn accumulate(&mut self, row: usize, distances: &[f64], first: usize) {
        let columns = self.band.row(row);
        let distances = &distances[columns.start - first..columns.end - first];
        let before = &self.before[columns.start..=columns.end];
        let present = &mut self.present[columns.start..=columns.end];
        // What an earlier row left here lies outside the band now.
        present[0] = f64::INFINITY;
        let mut beside = f64::INFINITY;
        let mut steps = self.steps.row(row);
        for (column, distance) in distances.iter().enumerate() {
            let diagonal = before[column] + 2.0 * distance;
            let along_a = before[column + 1] + distance;
            let along_b = beside + distance;
            let (mut best, mut step) = (diagonal, Step::Both);
            if along_a < best {
                (best, step) = (along_a, Step::A);
            }
            if along_b < best {
                (best, step) = (along_b, Step::B);
            }
            steps.push(step);
            present[column + 1] = best;
            beside = best;
        }
        steps.flush();
        core::mem::swap(&mut self.before, &mut self.present);
        self.row = row + 1;
    }

    /// Follows the path back by so many steps, at least one; how many there are then.
    fn walk(&mut self, steps: usize) -> usize {
        let end = (self.a.len() - 1, self.b.frames - 1);
        let (mut a, mut b) = match self.path.last() {
            Some(last) => *last,
            None => {
                self.path.push(end);
                end
            }
        };
        for _ in 0..steps.max(1) {
            if (a, b) == (0, 0) {
                break;
            }
            let step = match (a, b) {
                (0, _) => Step::B,
                (_, 0) => Step::A,
                _ => self.steps.at(a, b, &self.band),
            };
            a -= usize::from(step != Step::B);
            b -= usize::from(step != Step::A);
            self.path.push((a, b));
        }
        self.path.len()
    }

    /// Measures about so many pairs of frames of the path; how many are measured then.
    fn measure(&mut self, cells: usize) -> usize {
        let measured = self.part_distances.len();
        let count = (cells / CELLS_OF_A_PAIR).max(1);
        for (a, b) in self.path.iter().skip(measured).take(count) {
            let distances = part_distances(&self.a[*a], &self.b.posture(*b));
            self.part_distances.push(distances);
        }
        self.part_distances.len()
    }
}

fn part_distances(a: &Posture, b: &Posture) -> [f64; PARTS] {
    let (mut sums, mut joints) = ([0.0; PARTS], [0.0; PARTS]);
    for (part, distance) in PART_OF_JOINT.iter().zip(joint_distances(a, b)) {
        sums[*part] += distance;
        joints[*part] += 1.0;
    }
    core::array::from_fn(|part| sums[part] / joints[part])
}

/// The value below which so large a part of the values lies; 0 without any.
fn quantile(mut values: Vec<f64>, part: f64) -> f64 {
    let last = values.len().saturating_sub(1);
    let place = (part * last as f64) as usize;
    if values.is_empty() {
        return 0.0;
    }
    *values.select_nth_unstable_by(place, f64::total_cmp).1
}

#[cfg(test)]
mod tests;
