//! The words that a pose is told in.

/// The part of the body that a word is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PosturePart {
    /// The left arm.
    LeftArm,
    /// The right arm.
    RightArm,
    /// Both arms.
    BothArms,
    /// The left leg.
    LeftLeg,
    /// The right leg.
    RightLeg,
    /// Both legs.
    BothLegs,
    /// The trunk, and with it the whole.
    Trunk,
}

/// What the part does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PostureState {
    /// Arm: the hand is well above the shoulder. Leg: the knee is about as high as the hip.
    Raised,
    /// Arm: straight and about level.
    Stretched,
    /// Arm or leg: before the body, before the other leg.
    Forward,
    /// Arm: behind the body.
    Back,
    /// Arm: the hand is on the other side of the body. Legs: the feet are on each other's side.
    Crossed,
    /// Elbow or knee: bent sharply.
    Bent,
    /// Leg: the straight leg is lifted high.
    High,
    /// Leg: the foot is off the ground, the knee is not raised.
    Lifted,
    /// Legs: the feet stand far from each other sideways.
    Apart,
    /// Trunk: leaning forward.
    LeaningForward,
    /// Trunk: leaning back.
    LeaningBack,
    /// Trunk: leaning to the left.
    LeaningLeft,
    /// Trunk: leaning to the right.
    LeaningRight,
    /// Trunk: near the ground and level.
    Lying,
    /// Trunk: upright, arms down, standing.
    Upright,
}

/// One word of a pose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PostureWord {
    /// The part of the body.
    pub part: PosturePart,
    /// What it does.
    pub state: PostureState,
}

impl PostureWord {
    /// Nothing to tell of one who stands with arms down.
    pub const UPRIGHT: PostureWord = PostureWord {
        part: PosturePart::Trunk,
        state: PostureState::Upright,
    };

    /// Its name in machine-readable output, e.g. `left-arm-raised`.
    pub fn name(self) -> String {
        format!("{}-{}", self.part.name(), self.state.name())
    }
}

impl PosturePart {
    /// Its name in machine-readable output.
    pub fn name(self) -> &'static str {
        match self {
            PosturePart::LeftArm => "left-arm",
            PosturePart::RightArm => "right-arm",
            PosturePart::BothArms => "both-arms",
            PosturePart::LeftLeg => "left-leg",
            PosturePart::RightLeg => "right-leg",
            PosturePart::BothLegs => "both-legs",
            PosturePart::Trunk => "trunk",
        }
    }
}

impl PostureState {
    /// Its name in machine-readable output.
    pub fn name(self) -> &'static str {
        match self {
            PostureState::Raised => "raised",
            PostureState::Stretched => "stretched",
            PostureState::Forward => "forward",
            PostureState::Back => "back",
            PostureState::Crossed => "crossed",
            PostureState::Bent => "bent",
            PostureState::High => "high",
            PostureState::Lifted => "lifted",
            PostureState::Apart => "apart",
            PostureState::LeaningForward => "leaning-forward",
            PostureState::LeaningBack => "leaning-back",
            PostureState::LeaningLeft => "leaning-left",
            PostureState::LeaningRight => "leaning-right",
            PostureState::Lying => "lying",
            PostureState::Upright => "upright",
        }
    }
}
