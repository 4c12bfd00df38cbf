//! The parts of a human body by which a moment is explained.

use super::role::PRINCIPAL_JOINTS;

/// A limb, or neck and head.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BodyPart {
    /// Left shoulder, elbow, wrist and finger.
    LeftArm,
    /// Right shoulder, elbow, wrist and finger.
    RightArm,
    /// Left knee, ankle and toe.
    LeftLeg,
    /// Right knee, ankle and toe.
    RightLeg,
    /// Neck and head.
    Head,
}

/// How many parts there are.
pub const BODY_PARTS: usize = 5;

impl BodyPart {
    /// All parts, in the order of their columns.
    pub const ALL: [BodyPart; BODY_PARTS] = [
        BodyPart::LeftArm,
        BodyPart::RightArm,
        BodyPart::LeftLeg,
        BodyPart::RightLeg,
        BodyPart::Head,
    ];

    /// The part of each principal joint, in the order of [`super::Role::PRINCIPAL`].
    pub const OF_PRINCIPAL: [BodyPart; PRINCIPAL_JOINTS] = {
        use BodyPart::{Head, LeftArm, LeftLeg, RightArm, RightLeg};
        [
            LeftArm, LeftArm, LeftArm, LeftArm, LeftLeg, LeftLeg, LeftLeg, RightArm, RightArm,
            RightArm, RightArm, RightLeg, RightLeg, RightLeg, Head, Head,
        ]
    };

    /// Its name in machine-readable output.
    pub fn name(self) -> &'static str {
        match self {
            BodyPart::LeftArm => "left_arm",
            BodyPart::RightArm => "right_arm",
            BodyPart::LeftLeg => "left_leg",
            BodyPart::RightLeg => "right_leg",
            BodyPart::Head => "head",
        }
    }

    /// Its column, from 0.
    pub fn index(self) -> usize {
        self as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::{Role, Side};

    #[test]
    fn every_principal_joint_has_its_part() {
        for (role, part) in Role::PRINCIPAL.iter().zip(BodyPart::OF_PRINCIPAL) {
            let expected = match role {
                Role::Neck | Role::Head => BodyPart::Head,
                _ if Role::arm(Side::Left).contains(role) => BodyPart::LeftArm,
                _ if Role::arm(Side::Right).contains(role) => BodyPart::RightArm,
                _ if Role::leg(Side::Left).contains(role) => BodyPart::LeftLeg,
                _ => BodyPart::RightLeg,
            };
            assert_eq!(part, expected, "{}", role.name());
        }
        let columns = BodyPart::ALL.map(BodyPart::index);
        assert_eq!(columns, [0, 1, 2, 3, 4]);
    }
}
