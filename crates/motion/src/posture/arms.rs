//! The words of the arms.

use super::pose::Pose;
use super::{Candidate, PosturePart, PostureState, best, paired};
use crate::body::{Role, Side};

/// The words that fit the arms, with their scores.
pub fn words(pose: &Pose) -> Vec<Candidate> {
    let parts = [
        PosturePart::LeftArm,
        PosturePart::RightArm,
        PosturePart::BothArms,
    ];
    paired(parts, Side::BOTH.map(|side| arm(pose, side)))
}

fn arm(pose: &Pose, side: Side) -> Option<(PostureState, f64)> {
    let limb = Role::arm(side);
    let reach = pose.reach(limb);
    let height = reach.dot(&pose.up);
    let level = (reach - pose.up * height).norm();
    let ahead = reach.dot(&pose.chest_forward());
    let is_low = height < 0.45;
    let beyond = |is_possible: bool, measure: f64, from: f64, range: f64| match is_possible {
        true => (measure - from) / range,
        false => 0.0,
    };
    best([
        (PostureState::Raised, beyond(!is_low, height, 0.4, 0.5)),
        (PostureState::Stretched, beyond(is_low, level, 0.8, 0.2)),
        (PostureState::Forward, beyond(is_low, ahead, 0.55, 0.6)),
        (PostureState::Back, beyond(is_low, -ahead, 0.5, 0.4)),
        (
            PostureState::Crossed,
            beyond(is_low && ahead > 0.0, across(pose, side), 0.03, 0.15),
        ),
        (
            PostureState::Bent,
            beyond(is_low, pose.bend(limb), 0.35, 1.2),
        ),
    ])
}

/// How far a hand is beyond the middle of the chest on the other side, in body heights.
fn across(pose: &Pose, side: Side) -> f64 {
    let middle = (pose.at(Role::LeftShoulder) + pose.at(Role::RightShoulder)) / 2.0;
    let [_, _, wrist, _] = Role::arm(side);
    let to_left = (pose.at(wrist) - middle).dot(&pose.chest_left());
    match side {
        Side::Left => -to_left,
        Side::Right => to_left,
    }
}
