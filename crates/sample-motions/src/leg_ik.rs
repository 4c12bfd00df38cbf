//! In: hip, ankle and the direction in which the knee shows. Out: how thigh and shin stand (two-bone inverse kinematics).

use crate::body::{SHIN, THIGH};
use crate::rotation::{Rotation, from_columns};
use nalgebra::Vector3;

/// A knee never locks: the leg reaches this share of its length.
pub const REACH: f64 = 0.9985 * (THIGH + SHIN);

/// How a leg stands in the world.
#[derive(Clone, Copy, Debug)]
pub struct Leg {
    pub world_from_thigh: Rotation,
    pub world_from_shin: Rotation,
}

/// The leg from `hip` to `ankle`; an ankle out of reach is approached as far as the leg goes.
pub fn solve(hip: &Vector3<f64>, ankle: &Vector3<f64>, knee_towards: &Vector3<f64>) -> Leg {
    let way = ankle - hip;
    let distance = way.norm().clamp(THIGH - SHIN + 1e-6, REACH);
    let along_leg = way.normalize();
    let forward = (knee_towards - along_leg * knee_towards.dot(&along_leg)).normalize();
    let along = (THIGH * THIGH - SHIN * SHIN + distance * distance) / (2.0 * distance);
    let knee = along_leg * along + forward * (THIGH * THIGH - along * along).max(0.0).sqrt();
    let axis = forward.cross(&along_leg);
    let bone = |up: Vector3<f64>| from_columns(axis, up.normalize(), axis.cross(&up).normalize());
    Leg {
        world_from_thigh: bone(-knee),
        world_from_shin: bone(knee - along_leg * distance),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ankle_of(hip: &Vector3<f64>, leg: &Leg) -> Vector3<f64> {
        let knee = hip + leg.world_from_thigh * Vector3::new(0.0, -THIGH, 0.0);
        knee + leg.world_from_shin * Vector3::new(0.0, -SHIN, 0.0)
    }

    #[test]
    fn the_ankle_is_reached_and_the_knee_bends_forward() {
        let hip = Vector3::new(0.06, 0.55, 0.1);
        for ankle in [
            [0.1, 0.06, 0.2],
            [0.06, 0.2, 0.0],
            [0.3, 0.3, -0.2],
            [0.06, 0.45, 0.4],
        ] {
            let ankle = Vector3::from(ankle);
            let leg = solve(&hip, &ankle, &Vector3::z());
            assert!((ankle_of(&hip, &leg) - ankle).norm() < 1e-12);
            let bend = leg.world_from_thigh.inverse() * leg.world_from_shin * Vector3::y();
            assert!(bend.z > 0.0, "the shin goes behind the thigh: {bend:?}");
        }
    }

    #[test]
    fn an_ankle_out_of_reach_is_approached() {
        let (hip, far) = (Vector3::new(0.0, 0.6, 0.0), Vector3::new(0.0, 0.0, 0.5));
        let reached = ankle_of(&hip, &solve(&hip, &far, &Vector3::z()));
        assert!((reached - hip).normalize().dot(&(far - hip).normalize()) > 1.0 - 1e-12);
        assert!(((reached - hip).norm() - REACH).abs() < 1e-12);
    }
}
