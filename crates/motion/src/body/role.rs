//! The places of a body that the analysis asks for.

/// Left or right, of the person.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Side {
    /// The person's left.
    Left,
    /// The person's right.
    Right,
}

impl Side {
    /// Both, left first.
    pub const BOTH: [Side; 2] = [Side::Left, Side::Right];

    /// 0 for left, 1 for right.
    pub fn index(self) -> usize {
        self as usize
    }
}

macro_rules! roles {
    ($($variant:ident $name:literal;)*) => {
        /// A place of the body that a joint can take.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub enum Role {
            $(#[doc = concat!("`", $name, "`.")] $variant,)*
        }

        impl Role {
            /// Every role: the 16 principal joints first, in their order, then pelvis and hips.
            pub const ALL: &'static [Role] = &[$(Role::$variant,)*];

            /// The role's name in files and on the command line, e.g. `left_shoulder`.
            pub fn name(self) -> &'static str {
                match self { $(Role::$variant => $name,)* }
            }

            /// The role of that name.
            pub fn from_name(name: &str) -> Option<Role> {
                match name { $($name => Some(Role::$variant),)* _ => None }
            }
        }
    };
}

roles! {
    LeftShoulder "left_shoulder";
    LeftElbow "left_elbow";
    LeftWrist "left_wrist";
    LeftFinger "left_finger";
    LeftKnee "left_knee";
    LeftAnkle "left_ankle";
    LeftToe "left_toe";
    RightShoulder "right_shoulder";
    RightElbow "right_elbow";
    RightWrist "right_wrist";
    RightFinger "right_finger";
    RightKnee "right_knee";
    RightAnkle "right_ankle";
    RightToe "right_toe";
    Neck "neck";
    Head "head";
    Pelvis "pelvis";
    LeftHip "left_hip";
    RightHip "right_hip";
}

/// Joints that the analysis follows (J of \[K\] and \[I\]).
pub const PRINCIPAL_JOINTS: usize = 16;

impl Role {
    /// The principal joints in the order of every coordinate row.
    pub const PRINCIPAL: [Role; PRINCIPAL_JOINTS] = [
        Role::LeftShoulder,
        Role::LeftElbow,
        Role::LeftWrist,
        Role::LeftFinger,
        Role::LeftKnee,
        Role::LeftAnkle,
        Role::LeftToe,
        Role::RightShoulder,
        Role::RightElbow,
        Role::RightWrist,
        Role::RightFinger,
        Role::RightKnee,
        Role::RightAnkle,
        Role::RightToe,
        Role::Neck,
        Role::Head,
    ];

    /// The three joints of an arm and its end: shoulder, elbow, wrist, finger.
    pub const fn arm(side: Side) -> [Role; 4] {
        match side {
            Side::Left => [
                Role::LeftShoulder,
                Role::LeftElbow,
                Role::LeftWrist,
                Role::LeftFinger,
            ],
            Side::Right => [
                Role::RightShoulder,
                Role::RightElbow,
                Role::RightWrist,
                Role::RightFinger,
            ],
        }
    }

    /// The three joints of a leg and its end: hip, knee, ankle, toe.
    pub const fn leg(side: Side) -> [Role; 4] {
        match side {
            Side::Left => [
                Role::LeftHip,
                Role::LeftKnee,
                Role::LeftAnkle,
                Role::LeftToe,
            ],
            Side::Right => [
                Role::RightHip,
                Role::RightKnee,
                Role::RightAnkle,
                Role::RightToe,
            ],
        }
    }

    /// The row of a principal joint in [`Role::PRINCIPAL`], and a place of its own for the others.
    pub fn index(self) -> usize {
        self as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_principal_joints_come_first_in_all() {
        assert_eq!(Role::ALL[..PRINCIPAL_JOINTS], Role::PRINCIPAL);
        for (index, role) in Role::ALL.iter().enumerate() {
            assert_eq!(role.index(), index);
            assert_eq!(Role::from_name(role.name()), Some(*role));
        }
    }
}
