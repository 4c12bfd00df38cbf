//! The words of the trunk.

use super::pose::{Pose, unit};
use super::{Candidate, PosturePart, PostureState, PostureWord};
use crate::body::Role;

/// The cosine of the steepest lean that goes without a word (25°).
const STRAIGHT: f64 = 0.906;

/// Hips lower than this above the ground, in body heights, with a level trunk: lying.
const ON_THE_GROUND: f64 = 0.25;

/// The words that fit the trunk, with their scores.
pub fn words(pose: &Pose) -> Vec<Candidate> {
    let trunk = unit(pose.trunk());
    let height = trunk.dot(&pose.up);
    let hips = pose
        .clearance(Role::LeftHip)
        .min(pose.clearance(Role::RightHip));
    let (state, score) = if height < 0.5 && hips < ON_THE_GROUND {
        (PostureState::Lying, 2.0)
    } else {
        (lean(pose), (STRAIGHT - height) / 0.5)
    };
    let word = PostureWord {
        part: PosturePart::Trunk,
        state,
    };
    let is_told = score > 0.0;
    is_told
        .then_some(Candidate { word, score })
        .into_iter()
        .collect()
}

/// Where the trunk leans.
fn lean(pose: &Pose) -> PostureState {
    let [left, forward] = pose.level_axes().map(|axis| axis.dot(&pose.trunk()));
    match forward.abs() >= left.abs() {
        true if forward > 0.0 => PostureState::LeaningForward,
        true => PostureState::LeaningBack,
        false if left > 0.0 => PostureState::LeaningLeft,
        false => PostureState::LeaningRight,
    }
}
