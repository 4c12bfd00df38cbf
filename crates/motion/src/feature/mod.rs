//! Features: a track of pelvis coordinates in, a vector that motions are compared by out.

pub mod posture_variation;

pub use posture_variation::{PostureVariation, posture_variation};
