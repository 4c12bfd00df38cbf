//! In: axes and angles in radians. Out: unit quaternions, with the same bits on every platform.
//!
//! nalgebra's own constructors from angles call the platform's sine; these call `libm`.

use nalgebra::{Matrix3, Quaternion, Rotation3, UnitQuaternion, Vector3};

pub type Rotation = UnitQuaternion<f64>;

/// Below this the two ends of a turn are as good as one direction.
const SAME: f64 = 1.0 - 1e-12;

fn half_turn(angle: f64, axis: [f64; 3]) -> Rotation {
    let (sin, cos) = libm::sincos(0.5 * angle);
    let [x, y, z] = axis.map(|a| a * sin);
    UnitQuaternion::new_unchecked(Quaternion::new(cos, x, y, z))
}

/// About the axis to the person's left: positive bows forward.
pub fn about_x(angle: f64) -> Rotation {
    half_turn(angle, [1.0, 0.0, 0.0])
}

/// About the vertical: positive turns to the left.
pub fn about_y(angle: f64) -> Rotation {
    half_turn(angle, [0.0, 1.0, 0.0])
}

/// About the axis forward: positive leans to the right.
pub fn about_z(angle: f64) -> Rotation {
    half_turn(angle, [0.0, 0.0, 1.0])
}

/// The rotation that takes x, y, z to three orthonormal columns.
pub fn from_columns(x: Vector3<f64>, y: Vector3<f64>, z: Vector3<f64>) -> Rotation {
    let matrix = Matrix3::from_columns(&[x, y, z]);
    UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(matrix))
}

/// The share `x` of the shortest turn from `a` to `b`.
pub fn slerp(a: &Rotation, b: &Rotation, x: f64) -> Rotation {
    let dot = a.coords.dot(&b.coords);
    let (b, dot) = if dot < 0.0 {
        (-b.coords, -dot)
    } else {
        (b.coords, dot)
    };
    let (from, to) = weights(dot, x);
    let sum = a.coords * from + b * to;
    UnitQuaternion::new_normalize(Quaternion::from(sum))
}

fn weights(dot: f64, x: f64) -> (f64, f64) {
    if dot > SAME {
        return (1.0 - x, x);
    }
    let angle = libm::acos(dot.max(-SAME));
    (libm::sin((1.0 - x) * angle), libm::sin(x * angle))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    #[test]
    fn axes_follow_the_right_hand() {
        let (x, y, z) = (Vector3::x(), Vector3::y(), Vector3::z());
        assert!((about_x(FRAC_PI_2) * y - z).norm() < 1e-15);
        assert!((about_y(FRAC_PI_2) * z - x).norm() < 1e-15);
        assert!((about_z(FRAC_PI_2) * x - y).norm() < 1e-15);
        assert!((from_columns(y, z, x) * x - y).norm() < 1e-15);
    }

    #[test]
    fn slerp_turns_evenly() {
        let turned = slerp(&about_x(0.2), &about_x(1.2), 0.25);
        assert!((turned * Vector3::y() - about_x(0.45) * Vector3::y()).norm() < 1e-14);
    }
}
