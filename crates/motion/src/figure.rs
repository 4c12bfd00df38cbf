//! How a clip is pictured: the side from which its poses are widest, and the pose of its thumbnail.

use nalgebra::Vector3;

use crate::track::PelvisTrack;
use crate::world::Up;

/// Yaws that are tried over half a turn.
const YAWS: usize = 24;

/// The yaw, in radians from 0 to below π, from which the outlines of `poses` are widest in sum.
///
/// Each pose is x, y, z of one joint after the other in the world. Of equally wide yaws the
/// smallest.
pub fn widest_side_yaw(poses: &[&[f64]], up: Up) -> f64 {
    let [right, quarter] = up.level_axes();
    let mut best = (0.0, f64::NEG_INFINITY);
    for step in 0..YAWS {
        let yaw = core::f64::consts::PI * step as f64 / YAWS as f64;
        let (sine, cosine) = libm::sincos(yaw);
        let across = right * cosine + quarter * sine;
        let width: f64 = poses.iter().map(|pose| width(pose, across)).sum();
        if width > best.1 {
            best = (yaw, width);
        }
    }
    best.0
}

/// The extent of a pose's joints along a direction.
fn width(pose: &[f64], across: Vector3<f64>) -> f64 {
    let place = |joint: &[f64]| joint[0] * across.x + joint[1] * across.y + joint[2] * across.z;
    let places = || pose.chunks_exact(3).map(place);
    let most = places().fold(f64::NEG_INFINITY, f64::max);
    let least = places().fold(f64::INFINITY, f64::min);
    if most >= least { most - least } else { 0.0 }
}

/// The frame of the file that pictures a clip: the keypose (a frame of the file) whose coordinates are farthest from the
/// clip's mean, without keyposes that frame of all. Of equals the first; none without frames.
pub fn thumbnail_frame(track: &PelvisTrack, keyposes: &[usize]) -> Option<usize> {
    let mean = mean(track);
    let distance = |frame: usize| -> f64 {
        let pairs = track.frame(frame).iter().zip(&mean);
        pairs
            .map(|(value, mean)| (value - mean) * (value - mean))
            .sum()
    };
    let last = track.first_frame + track.frames();
    let inside = |frame: &usize| (track.first_frame..last).contains(frame);
    let mut chosen: Vec<usize> = keyposes.iter().copied().filter(inside).collect();
    if chosen.is_empty() {
        chosen = (track.first_frame..last).collect();
    }
    let mut best: Option<(usize, f64)> = None;
    for frame in chosen {
        let far = distance(frame - track.first_frame);
        if best.is_none_or(|(_, most)| far > most) {
            best = Some((frame, far));
        }
    }
    best.map(|(frame, _)| frame)
}

fn mean(track: &PelvisTrack) -> Vec<f64> {
    let mut sum = vec![0.0; 3 * track.joint_count];
    for frame in 0..track.frames() {
        for (sum, value) in sum.iter_mut().zip(track.frame(frame)) {
            *sum += value;
        }
    }
    let count = track.frames().max(1) as f64;
    sum.into_iter().map(|sum| sum / count).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_widest_side_looks_across_the_pose() {
        let along_x = [0.0, 0.0, 0.0, 2.0, 5.0, 0.0];
        let along_z = [0.0, 0.0, 0.0, 0.0, 5.0, 2.0];
        let yaw = |pose: &[f64]| widest_side_yaw(&[pose], Up::PLUS_Y);
        assert_eq!(yaw(&along_x), 0.0);
        assert_eq!(yaw(&along_z), core::f64::consts::FRAC_PI_2);
        assert_eq!(widest_side_yaw(&[], Up::PLUS_Y), 0.0);
    }

    #[test]
    fn the_thumbnail_is_the_keypose_farthest_from_the_mean() {
        let track = PelvisTrack {
            coordinates: [0.0, 1.0, 0.0, 9.0, 0.0]
                .iter()
                .flat_map(|x| [*x, 0.0, 0.0])
                .collect(),
            joint_count: 1,
            first_frame: 10,
        };
        assert_eq!(thumbnail_frame(&track, &[]), Some(13));
        assert_eq!(thumbnail_frame(&track, &[11, 12]), Some(12));
        assert_eq!(thumbnail_frame(&track, &[99]), Some(13));
    }
}
