//! In: where upper arm and forearm point, in the thorax. Out: the turn of the shoulder, the bend of the elbow, the lift of the clavicle.

use crate::body::Side;
use crate::rotation::{Rotation, about_x, about_y, about_z, from_columns, slerp};
use nalgebra::Vector3;

/// How an arm is held, in the thorax; angles in radians.
#[derive(Clone, Copy, Debug)]
pub struct Arm {
    pub thorax_from_upper_arm: Rotation,
    /// 0 is straight.
    pub elbow: f64,
    /// Turn of the forearm about its length: positive shows the palm up when the arm is in front.
    pub supination: f64,
    /// Bend of the wrist to the palm.
    pub wrist: f64,
}

impl Arm {
    /// An arm whose bones have the directions (out, up, forward) in the thorax. They may not be parallel: the
    /// plane of the two is the plane in which the elbow bends.
    pub fn pointing(side: Side, upper: [f64; 3], fore: [f64; 3]) -> Self {
        let upper = side.mirror(upper).normalize();
        let fore = side.mirror(fore).normalize();
        let hinge = upper.cross(&fore).normalize();
        let x = upper * side.sign();
        let y = hinge * -side.sign();
        Self {
            thorax_from_upper_arm: from_columns(x, y, x.cross(&y)),
            elbow: libm::acos(upper.dot(&fore).clamp(-1.0, 1.0)),
            supination: 0.0,
            wrist: 0.0,
        }
    }

    /// Shares of the way to another arm: of shoulder, elbow and hand, which follow one another.
    pub fn towards(&self, to: &Self, [shoulder, elbow, hand]: [f64; 3]) -> Self {
        let (a, b) = (&self.thorax_from_upper_arm, &to.thorax_from_upper_arm);
        Self {
            thorax_from_upper_arm: slerp(a, b, shoulder),
            elbow: self.elbow + elbow * (to.elbow - self.elbow),
            supination: self.supination + hand * (to.supination - self.supination),
            wrist: self.wrist + hand * (to.wrist - self.wrist),
        }
    }

    /// The bent elbow.
    pub fn upper_arm_from_forearm(&self, side: Side) -> Rotation {
        about_y(-side.sign() * self.elbow) * about_x(-self.supination)
    }

    /// The bent wrist.
    pub fn forearm_from_hand(&self, side: Side) -> Rotation {
        about_z(-side.sign() * self.wrist)
    }

    /// The clavicle follows the arm: it rises with a lifted one and comes forward with one in front.
    pub fn thorax_from_clavicle(&self, side: Side) -> Rotation {
        let upper = self.thorax_from_upper_arm * Vector3::new(side.sign(), 0.0, 0.0);
        let lift = 0.5 * (1.0 + upper.y);
        about_z(side.sign() * 0.32 * lift * lift) * about_y(-side.sign() * 0.16 * upper.z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bones_point_where_they_are_told() {
        for side in Side::BOTH {
            let (upper, fore) = ([0.4, 0.8, 0.2], [-0.3, 0.9, 0.4]);
            let arm = Arm::pointing(side, upper, fore);
            let along = Vector3::new(side.sign(), 0.0, 0.0);
            let upper_arm = arm.thorax_from_upper_arm;
            let forearm = upper_arm * arm.upper_arm_from_forearm(side);
            assert!((upper_arm * along - side.mirror(upper).normalize()).norm() < 1e-12);
            assert!((forearm * along - side.mirror(fore).normalize()).norm() < 1e-12);
        }
    }
}
