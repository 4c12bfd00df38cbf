//! The body: where each joint of an adult stands in the rest pose, in body heights.
//!
//! Axes: x to the person's left, y up, z forward; the ground is y = 0. The rest pose is a T: arms straight
//! out, palms down, feet forward. Lengths are the mean of 109 motion-capture rigs in body heights (hip
//! middle to shoulder middle .297, upper arm .169, forearm .151, hand .080, thigh .263, shin .257).

use nalgebra::Vector3;

/// A side of the body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    Left,
    Right,
}

impl Side {
    pub const BOTH: [Self; 2] = [Self::Left, Self::Right];

    /// +1 for the left, −1 for the right: the sign of x on that side.
    pub fn sign(self) -> f64 {
        match self {
            Self::Left => 1.0,
            Self::Right => -1.0,
        }
    }

    /// A vector given for the left side, on this side.
    pub fn mirror(self, [out, up, forward]: [f64; 3]) -> Vector3<f64> {
        Vector3::new(self.sign() * out, up, forward)
    }
}

/// A part of the body that moves as one piece.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Segment {
    Pelvis,
    Lumbar,
    Midriff,
    Thorax,
    Neck,
    Head,
    Limb(Side, Limb),
}

/// A segment that exists on both sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limb {
    Clavicle,
    UpperArm,
    Forearm,
    Hand,
    Fingers,
    Thigh,
    Shin,
    Foot,
    Toes,
}

pub const THIGH: f64 = 0.263;
pub const SHIN: f64 = 0.257;

/// Rest positions on the left side; z of the trunk follows the curve of the spine.
pub const HIP: [f64; 3] = [0.057, 0.560, 0.0];
pub const KNEE: [f64; 3] = [0.057, HIP[1] - THIGH, 0.0];
pub const ANKLE: [f64; 3] = [0.057, KNEE[1] - SHIN, 0.0];
pub const BALL: [f64; 3] = [0.057, 0.010, 0.078];
pub const TOE_TIP: [f64; 3] = [0.057, 0.008, 0.118];
pub const PELVIS: [f64; 3] = [0.0, 0.592, -0.004];
pub const LUMBAR: [f64; 3] = [0.0, 0.634, -0.008];
pub const MIDRIFF: [f64; 3] = [0.0, 0.700, -0.006];
pub const THORAX: [f64; 3] = [0.0, 0.766, -0.012];
pub const NECK: [f64; 3] = [0.0, 0.893, -0.012];
pub const HEAD: [f64; 3] = [0.0, 0.934, 0.002];
pub const HEAD_TOP: [f64; 3] = [0.0, 1.010, 0.010];
pub const CLAVICLE: [f64; 3] = [0.018, 0.850, 0.006];
pub const SHOULDER: [f64; 3] = [0.1055, 0.857, -0.008];
pub const ELBOW: [f64; 3] = [0.2745, 0.857, -0.008];
pub const WRIST: [f64; 3] = [0.4255, 0.857, -0.008];
pub const KNUCKLE: [f64; 3] = [0.4745, 0.856, -0.006];
pub const FINGER_TIP: [f64; 3] = [0.5155, 0.853, -0.006];

/// The foot turns on the joint of its ball, while the toes stay, or on its heel; both given from the ankle.
pub const BALL_FROM_ANKLE: Vector3<f64> = Vector3::new(0.0, BALL[1] - ANKLE[1], BALL[2]);
pub const HEEL_FROM_ANKLE: Vector3<f64> = Vector3::new(0.0, -ANKLE[1], -0.028);

/// The hip joint from the middle of the hips, in the pelvis.
pub fn hip_from_middle(side: Side) -> Vector3<f64> {
    side.mirror([HIP[0], 0.0, 0.0])
}
