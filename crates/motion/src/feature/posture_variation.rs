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
const AXES: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)];

/// The feature of a track; zeros for one without frames.
///
/// One pass over the frames with Welford's running mean and deviation, so that no large squares
/// are subtracted.
pub fn posture_variation(track: &PelvisTrack) -> [f64; 12] {
    let mut mean = [0.0; 6];
    let mut squares = [0.0; 6];
    for frame in 0..track.frames() {
        let count = (frame + 1) as f64;
        let covariance = covariance(track.frame(frame));
        for axis in 0..6 {
            let before = covariance[axis] - mean[axis];
            mean[axis] += before / count;
            squares[axis] += before * (covariance[axis] - mean[axis]);
        }
    }
    let frames = track.frames().max(1) as f64;
    std::array::from_fn(|index| match index {
        0..6 => mean[index],
        _ => (squares[index - 6] / frames).sqrt(),
    })
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
