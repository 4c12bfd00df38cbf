//! A motion over time: in comes a time, out comes a posture; and the times of its true keyposes.

use crate::posture::Posture;

pub trait Take {
    fn duration_s(&self) -> f64;

    fn posture(&self, time_s: f64) -> Posture;

    /// From and to of each keypose, in order; equal for an instant.
    fn keyposes_s(&self) -> Vec<[f64; 2]>;
}
