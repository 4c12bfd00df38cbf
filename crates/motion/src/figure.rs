//! How a clip is pictured: poses go in one by one; the side from which they are widest, and the one
//! of the thumbnail, come out.

use nalgebra::Vector3;

use crate::world::Up;

/// Yaws that are tried over half a turn.
const YAWS: usize = 24;

/// The yaw, in radians from 0 to below π, from which the outlines of some poses are widest in sum.
#[derive(Clone, Debug)]
pub struct WidestSide {
    /// For each yaw that is tried the direction across, and the widths so far.
    tried: [(Vector3<f64>, f64); YAWS],
}

impl WidestSide {
    /// The widest side of poses in a world with this up axis.
    pub fn new(up: Up) -> Self {
        let [right, quarter] = up.level_axes();
        let across = |step: usize| {
            let (sine, cosine) = libm::sincos(yaw_rad(step));
            (right * cosine + quarter * sine, 0.0)
        };
        Self {
            tried: core::array::from_fn(across),
        }
    }

    /// Takes a pose: x, y, z of one joint after the other in the world.
    pub fn add(&mut self, pose: &[f64]) {
        for (across, sum) in &mut self.tried {
            *sum += width(pose, *across);
        }
    }

    /// The yaw; of equally wide ones the smallest.
    pub fn yaw_rad(&self) -> f64 {
        let wider = |best: usize, step: usize| match self.tried[step].1 > self.tried[best].1 {
            true => step,
            false => best,
        };
        yaw_rad((0..YAWS).fold(0, wider))
    }
}

fn yaw_rad(step: usize) -> f64 {
    core::f64::consts::PI * step as f64 / YAWS as f64
}

/// The extent of a pose's joints along a direction.
fn width(pose: &[f64], across: Vector3<f64>) -> f64 {
    let place = |joint: &[f64]| joint[0] * across.x + joint[1] * across.y + joint[2] * across.z;
    let places = || pose.chunks_exact(3).map(place);
    let most = places().fold(f64::NEG_INFINITY, f64::max);
    let least = places().fold(f64::INFINITY, f64::min);
    if most >= least { most - least } else { 0.0 }
}

/// The pose farthest from the mean of its motion, which pictures it. Of equals the first.
#[derive(Clone, Copy, Debug, Default)]
pub struct FarthestPose(Option<(usize, f64)>);

impl FarthestPose {
    /// Takes the coordinates of a frame, and the mean of all.
    pub fn add(&mut self, frame: usize, coordinates: &[f64], mean: &[f64]) {
        let pairs = coordinates.iter().zip(mean);
        let squares = pairs.map(|(value, mean)| (value - mean) * (value - mean));
        let distance: f64 = squares.sum();
        if self.0.is_none_or(|(_, most)| distance > most) {
            self.0 = Some((frame, distance));
        }
    }

    /// Its frame; none without poses.
    pub fn frame(&self) -> Option<usize> {
        self.0.map(|(frame, _)| frame)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_widest_side_looks_across_the_pose() {
        let along_x = [0.0, 0.0, 0.0, 2.0, 5.0, 0.0];
        let along_z = [0.0, 0.0, 0.0, 0.0, 5.0, 2.0];
        let yaw = |poses: &[[f64; 6]]| {
            let mut side = WidestSide::new(Up::PLUS_Y);
            poses.iter().for_each(|pose| side.add(pose));
            side.yaw_rad()
        };
        assert_eq!(yaw(&[along_x]), 0.0);
        assert_eq!(yaw(&[along_z]), core::f64::consts::FRAC_PI_2);
        assert_eq!(yaw(&[along_x, along_z]), core::f64::consts::FRAC_PI_4);
        assert_eq!(yaw(&[]), 0.0);
    }

    #[test]
    fn the_farthest_pose_is_the_first_of_equals() {
        let mut farthest = FarthestPose::default();
        assert_eq!(farthest.frame(), None);
        for (frame, x) in [(10, 1.0), (11, 9.0), (12, -5.0), (13, 0.0)] {
            farthest.add(frame, &[x, 0.0], &[2.0, 0.0]);
        }
        assert_eq!(farthest.frame(), Some(11));
    }
}
