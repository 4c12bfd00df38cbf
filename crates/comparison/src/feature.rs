//! What is compared of a clip: its posture-variation feature, and what each joint adds to it.

/// Numbers of a feature: the means of σ_xx, σ_yy, σ_zz, σ_xy, σ_yz, σ_zx, then their deviations.
pub const FEATURE_LENGTH: usize = 12;

/// The principal joints, in the order of the pelvis coordinates.
pub const JOINTS: usize = 16;

/// Parts of a body: left arm, right arm, left leg, right leg, head.
pub const PARTS: usize = 5;

/// The part of each joint.
pub const PART_OF_JOINT: [usize; JOINTS] = [0, 0, 0, 0, 2, 2, 2, 1, 1, 1, 1, 3, 3, 3, 4, 4];

/// A posture-variation feature in squared body heights.
pub type Vector = [f64; FEATURE_LENGTH];

/// One clip as a comparison knows it.
#[derive(Clone, Debug, PartialEq)]
pub struct ClipFeature {
    /// The feature of the recorded postures.
    pub recorded: Vector,
    /// The feature of the same motion on a body of standard lengths, for comparing across rigs.
    pub across_rigs: Vector,
    /// What each joint adds to `recorded`; the joints sum up to it.
    pub recorded_by_joint: [Vector; JOINTS],
    /// What each joint adds to `across_rigs`.
    pub across_rigs_by_joint: [Vector; JOINTS],
}
