//! Features: a track of pelvis coordinates in, a vector that motions are compared by out.

mod comparable;
mod joint_variation;
pub mod posture_variation;
mod standard_body;

pub use comparable::{ComparableFeature, Comparing};
pub use joint_variation::{JointVariation, VariationOfJoints};
pub use posture_variation::{PostureVariation, posture_variation};
pub use standard_body::{Hips, standard_posture};
