//! In: a figure (hips, trunk, arms, and where the feet are). Out: the orientation of every segment in the world.

use crate::arm::Arm;
use crate::body::{Limb, Segment, Side, hip_from_middle};
use crate::leg_ik;
use crate::rotation::{Rotation, about_x, about_y, about_z, slerp};
use nalgebra::Vector3;

/// A bend of the trunk or of the head, in radians: forward, to the right, to the left about the length.
#[derive(Clone, Copy, Debug, Default)]
pub struct Bend {
    pub forward: f64,
    pub right: f64,
    pub turn: f64,
}

impl Bend {
    pub fn degrees([forward, right, turn]: [f64; 3]) -> Self {
        let [forward, right, turn] = [forward, right, turn].map(f64::to_radians);
        Self {
            forward,
            right,
            turn,
        }
    }

    pub fn towards(&self, to: &Self, x: f64) -> Self {
        Self {
            forward: self.forward + x * (to.forward - self.forward),
            right: self.right + x * (to.right - self.right),
            turn: self.turn + x * (to.turn - self.turn),
        }
    }

    /// The share `x` of the bend.
    pub fn rotation(&self, x: f64) -> Rotation {
        about_y(x * self.turn) * about_x(x * self.forward) * about_z(x * self.right)
    }
}

/// Where a foot is, in the world.
#[derive(Clone, Copy, Debug)]
pub struct Foot {
    pub ankle: Vector3<f64>,
    pub world_from_foot: Rotation,
    /// Direction in which the knee shows.
    pub knee_towards: Vector3<f64>,
    /// Bend of the toes upwards, in radians.
    pub toes_up: f64,
}

/// All that is needed to stand a body in the world; lengths in body heights.
#[derive(Clone, Copy, Debug)]
pub struct Figure {
    pub hip_middle: Vector3<f64>,
    pub world_from_pelvis: Rotation,
    pub trunk: Bend,
    pub head: Bend,
    pub arms: [Arm; 2],
    pub feet: [Foot; 2],
}

/// The orientation of every segment, relative to the T pose, and the middle of the hips.
#[derive(Clone, Copy, Debug)]
pub struct Posture {
    pub hip_middle: Vector3<f64>,
    trunk: [Rotation; 6],
    limbs: [[Rotation; 9]; 2],
}

impl Posture {
    pub fn world_from(&self, segment: Segment) -> Rotation {
        match segment {
            Segment::Pelvis => self.trunk[0],
            Segment::Lumbar => self.trunk[1],
            Segment::Midriff => self.trunk[2],
            Segment::Thorax => self.trunk[3],
            Segment::Neck => self.trunk[4],
            Segment::Head => self.trunk[5],
            Segment::Limb(side, limb) => self.limbs[side as usize][limb as usize],
        }
    }

    /// The posture with arms and trunk at these shares of their turns from a still posture; above 1 they go
    /// farther. Pelvis and legs stay, so that the feet do.
    pub fn farther(&self, still: &Self, arms: f64, trunk: f64) -> Self {
        let mut posture = *self;
        let [pelvis, still_pelvis] = [self.trunk[0], still.trunk[0]];
        for (part, bent) in posture.trunk.iter_mut().enumerate().skip(1) {
            let from = still_pelvis.inverse() * still.trunk[part];
            let to = pelvis.inverse() * self.trunk[part];
            *bent = pelvis * slerp(&from, &to, trunk);
        }
        let [thorax, still_thorax] = [self.trunk[THORAX], still.trunk[THORAX]];
        for side in Side::BOTH.map(|side| side as usize) {
            for limb in ARM.map(|limb| limb as usize) {
                let from = still_thorax.inverse() * still.limbs[side][limb];
                let to = thorax.inverse() * self.limbs[side][limb];
                posture.limbs[side][limb] = posture.trunk[THORAX] * slerp(&from, &to, arms);
            }
        }
        posture
    }
}

/// Place of the thorax in the trunk.
const THORAX: usize = 3;
/// What hangs from the thorax.
const ARM: [Limb; 5] = [
    Limb::Clavicle,
    Limb::UpperArm,
    Limb::Forearm,
    Limb::Hand,
    Limb::Fingers,
];

/// Fingers of a hand at rest are bent this much.
const FINGER_CURL: f64 = 0.25;

impl Figure {
    pub fn posture(&self) -> Posture {
        let pelvis = self.world_from_pelvis;
        let thorax = pelvis * self.trunk.rotation(1.0);
        let trunk = [
            pelvis,
            pelvis * self.trunk.rotation(0.33),
            pelvis * self.trunk.rotation(0.67),
            thorax,
            thorax * self.head.rotation(0.45),
            thorax * self.head.rotation(1.0),
        ];
        let limbs = Side::BOTH.map(|side| self.limbs(side, thorax));
        Posture {
            hip_middle: self.hip_middle,
            trunk,
            limbs,
        }
    }

    fn limbs(&self, side: Side, world_from_thorax: Rotation) -> [Rotation; 9] {
        let arm = &self.arms[side as usize];
        let upper_arm = world_from_thorax * arm.thorax_from_upper_arm;
        let forearm = upper_arm * arm.upper_arm_from_forearm(side);
        let hand = forearm * arm.forearm_from_hand(side);
        let foot = &self.feet[side as usize];
        let leg = leg_ik::solve(&self.hip(side), &foot.ankle, &foot.knee_towards);
        let mut limbs = [Rotation::identity(); 9];
        let mut set = |limb: Limb, rotation| limbs[limb as usize] = rotation;
        set(
            Limb::Clavicle,
            world_from_thorax * arm.thorax_from_clavicle(side),
        );
        set(Limb::UpperArm, upper_arm);
        set(Limb::Forearm, forearm);
        set(Limb::Hand, hand);
        set(Limb::Fingers, hand * about_z(-side.sign() * FINGER_CURL));
        set(Limb::Thigh, leg.world_from_thigh);
        set(Limb::Shin, leg.world_from_shin);
        set(Limb::Foot, foot.world_from_foot);
        set(Limb::Toes, foot.world_from_foot * about_x(-foot.toes_up));
        limbs
    }

    pub fn hip(&self, side: Side) -> Vector3<f64> {
        self.hip_middle + self.world_from_pelvis * hip_from_middle(side)
    }
}
