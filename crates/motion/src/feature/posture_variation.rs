//! Posture variation: a track of pelvis coordinates in, 12 numbers in squared body heights out.
//!
//! At each frame the population covariance of the joint positions gives
//! `f = (σ_xx, σ_yy, σ_zz, σ_xy, σ_yz, σ_zx)`; the feature is the mean of f over the frames, then
//! its standard deviation (both divided by the number of frames).
//!
//! Source: Miura et al., "Indexing of Motion Capture Data Using Feature Vectors Derived from
//! Posture Variation", 2013, eq. 1–3.

use crate::track::PelvisTrack;

/// The pairs of axes of σ_xx, σ_yy, σ_zz, σ_xy, σ_yz, σ_zx.
pub(super) const AXES: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)];

/// The feature while frames come in, with Welford's running mean and deviation, so that no large
/// squares are subtracted.
#[derive(Clone, Debug, Default)]
pub struct PostureVariation {
    frames: usize,
    mean: [f64; 6],
    squares: [f64; 6],
}

impl PostureVariation {
    /// Adds a frame: x, y, z of joint after joint.
    pub fn add(&mut self, posture: &[f64]) {
        self.add_covariance(covariance(posture));
    }

    /// Adds a frame by its f; returns how far f lies from the mean with it.
    pub(super) fn add_covariance(&mut self, covariance: [f64; 6]) -> [f64; 6] {
        self.frames += 1;
        let count = self.frames as f64;
        let mut deviation = covariance;
        let running = self.mean.iter_mut().zip(&mut self.squares);
        for (value, (mean, squares)) in deviation.iter_mut().zip(running) {
            let before = *value - *mean;
            *mean += before / count;
            *value -= *mean;
            *squares += before * *value;
        }
        deviation
    }

    /// Frames added.
    pub(super) fn frames(&self) -> usize {
        self.frames
    }

    /// The feature of the frames added; zeros without any.
    pub fn feature(&self) -> [f64; 12] {
        let frames = self.frames.max(1) as f64;
        std::array::from_fn(|index| match index {
            0..6 => self.mean[index],
            _ => (self.squares[index - 6] / frames).sqrt(),
        })
    }
}

/// The feature of a track; zeros for one without frames.
pub fn posture_variation(track: &PelvisTrack) -> [f64; 12] {
    let mut variation = PostureVariation::default();
    for frame in 0..track.frames() {
        variation.add(track.frame(frame));
    }
    variation.feature()
}

/// The population covariance of the points of one posture, x, y, z after each other.
fn covariance(posture: &[f64]) -> [f64; 6] {
    let joints = (posture.len() / 3) as f64;
    let mut center = [0.0; 3];
    for point in posture.chunks_exact(3) {
        for axis in 0..3 {
            center[axis] += point[axis];
        }
    }
    center = center.map(|sum| sum / joints);
    let mut sums = [0.0; 6];
    for point in posture.chunks_exact(3) {
        for (sum, (a, b)) in sums.iter_mut().zip(AXES) {
            *sum += (point[a] - center[a]) * (point[b] - center[b]);
        }
    }
    sums.map(|sum| sum / joints)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn track(coordinates: Vec<f64>, joint_count: usize) -> PelvisTrack {
        PelvisTrack {
            coordinates,
            joint_count,
            first_frame: 0,
        }
    }

    #[test]
    fn two_points_and_two_frames_by_hand() {
        // Half distances (1, 2, 3) and (3, 2, 1) around the middle: products are covariances.
        let frame_0 = [4.0, 4.0, 4.0, 6.0, 8.0, 10.0];
        let frame_1 = [0.0, 0.0, 0.0, 6.0, 4.0, 2.0];
        let feature = posture_variation(&track([frame_0, frame_1].concat(), 2));
        let expected = [5.0, 4.0, 5.0, 4.0, 4.0, 3.0, 4.0, 0.0, 4.0, 2.0, 2.0, 0.0];
        for (found, expected) in feature.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-14, "{feature:?}");
        }
    }

    #[test]
    fn a_far_origin_costs_no_digits_of_the_deviation() {
        let near: Vec<f64> = (0..600).map(|n| libm::sin(f64::from(n))).collect();
        let far: Vec<f64> = near.iter().map(|value| value + 1024.0).collect();
        let (near, far) = (
            posture_variation(&track(near, 2)),
            posture_variation(&track(far, 2)),
        );
        for (near, far) in near.iter().zip(far) {
            assert!((near - far).abs() < 1e-11);
        }
    }

    #[test]
    fn a_track_without_frames_or_joints_is_zero() {
        assert_eq!(posture_variation(&track(Vec::new(), 16)), [0.0; 12]);
        assert_eq!(posture_variation(&track(Vec::new(), 0)), [0.0; 12]);
    }
}
