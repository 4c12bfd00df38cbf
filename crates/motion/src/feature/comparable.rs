//! What a comparison takes of a clip: postures and hips in, the features of the motion as recorded and
//! on a body of standard lengths out, each with the joints' parts.

use super::joint_variation::{JointVariation, VariationOfJoints, WIDTH};
use super::standard_body::{Hips, standard_posture};
use crate::body::PRINCIPAL_JOINTS;

/// Posture variation in squared body heights, for comparing one human clip with others.
#[derive(Clone, Debug, PartialEq)]
pub struct ComparableFeature {
    /// The feature of the recorded postures: `PerformerAnalysis::feature`.
    pub recorded: [f64; 12],
    /// That of the same bone directions on a body of standard lengths.
    pub across_rigs: [f64; 12],
    /// What each joint adds to `recorded`; the joints sum up to it.
    pub recorded_by_joint: [[f64; 12]; PRINCIPAL_JOINTS],
    /// What each joint adds to `across_rigs`.
    pub across_rigs_by_joint: [[f64; 12]; PRINCIPAL_JOINTS],
}

/// The features while frames come in.
#[derive(Clone, Debug, Default)]
pub struct Comparing {
    recorded: JointVariation,
    across_rigs: JointVariation,
}

impl Comparing {
    /// Adds a frame: x, y, z of each principal joint and the hips, in pelvis coordinates.
    pub fn add(&mut self, posture: &[f64; WIDTH], hips: &Hips) {
        self.recorded.add(posture);
        self.across_rigs.add(&standard_posture(posture, hips));
    }

    /// The features of the frames added; zeros without any.
    pub fn finish(&self) -> ComparableFeature {
        let recorded = self.recorded.finish();
        let VariationOfJoints { feature, by_joint } = self.across_rigs.finish();
        ComparableFeature {
            recorded: recorded.feature,
            recorded_by_joint: recorded.by_joint,
            across_rigs: feature,
            across_rigs_by_joint: by_joint,
        }
    }
}
