//! In: a rotation and the order of three channels. Out: the three angles in degrees, near those of the frame before.

use crate::rotation::Rotation;
use std::f64::consts::{PI, TAU};

/// An axis of rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    X,
    Y,
    Z,
}

impl Axis {
    /// The letter of a channel's name.
    pub fn letter(self) -> char {
        ['X', 'Y', 'Z'][self as usize]
    }
}

/// Angles a, b, c in degrees with R = R_i(a) R_j(b) R_k(c) for the order (i, j, k) of three different axes.
///
/// Of the two solutions, and of all full turns, the one nearest to `previous` is taken, so that a
/// channel never jumps.
pub fn angles(rotation: &Rotation, order: [Axis; 3], previous: [f64; 3]) -> [f64; 3] {
    let one = principal(rotation, order);
    let other = [one[0] + PI, PI - one[1], one[2] + PI];
    let [one, other] = [one, other].map(|a| near(a.map(f64::to_degrees), previous));
    if distance(one, previous) <= distance(other, previous) {
        one
    } else {
        other
    }
}

fn principal(rotation: &Rotation, order: [Axis; 3]) -> [f64; 3] {
    let [i, j, k] = order.map(|axis| axis as usize);
    let sign = if (i + 1) % 3 == j { 1.0 } else { -1.0 };
    let m = rotation.to_rotation_matrix();
    let cos = (m[(i, i)] * m[(i, i)] + m[(i, j)] * m[(i, j)]).sqrt();
    [
        libm::atan2(-sign * m[(j, k)], m[(k, k)]),
        libm::atan2(sign * m[(i, k)], cos),
        libm::atan2(-sign * m[(i, j)], m[(i, i)]),
    ]
}

fn near(angles: [f64; 3], previous: [f64; 3]) -> [f64; 3] {
    let turn = TAU.to_degrees();
    let shift = |n: usize| turn * libm::round((previous[n] - angles[n]) / turn);
    [0, 1, 2].map(|n| angles[n] + shift(n))
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (a[0] - b[0]).abs() + (a[1] - b[1]).abs() + (a[2] - b[2]).abs()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rotation::{about_x, about_y, about_z};
    use Axis::{X, Y, Z};

    fn rebuilt(order: [Axis; 3], degrees: [f64; 3]) -> Rotation {
        let turn = |n: usize| match order[n] {
            X => about_x(degrees[n].to_radians()),
            Y => about_y(degrees[n].to_radians()),
            Z => about_z(degrees[n].to_radians()),
        };
        turn(0) * turn(1) * turn(2)
    }

    #[test]
    fn every_order_gives_the_rotation_back() {
        let orders = [
            [X, Y, Z],
            [X, Z, Y],
            [Y, X, Z],
            [Y, Z, X],
            [Z, X, Y],
            [Z, Y, X],
        ];
        let rotation = about_y(2.1) * about_x(-0.7) * about_z(1.3);
        for order in orders {
            let again = rebuilt(order, angles(&rotation, order, [0.0; 3]));
            assert!((again.inverse() * rotation).angle() < 1e-7, "{order:?}");
        }
    }

    #[test]
    fn angles_stay_near_the_frame_before() {
        let before = [170.0, 80.0, -350.0];
        let rotation = rebuilt([Z, X, Y], [190.0, 95.0, -370.0]);
        let after = angles(&rotation, [Z, X, Y], before);
        for n in 0..3 {
            assert!((after[n] - [190.0, 95.0, -370.0][n]).abs() < 1e-9);
        }
    }
}
