//! The words of the legs and feet.

use super::pose::{Pose, unit};
use super::{Candidate, PosturePart, PostureState, PostureWord, best, paired};
use crate::body::{Role, Side};

/// An ankle or a toe lower than this above the ground, in body heights, belongs to a foot that
/// stands, maybe on tiptoe.
const STANDING: [f64; 2] = [0.15, 0.08];

/// The words that fit the legs, with their scores: at most one for each, or one for both.
pub fn words(pose: &Pose) -> Vec<Candidate> {
    let parts = [
        PosturePart::LeftLeg,
        PosturePart::RightLeg,
        PosturePart::BothLegs,
    ];
    let words = paired(parts, Side::BOTH.map(|side| leg(pose, side)));
    let words = words.into_iter().chain(stance(pose));
    let larger = |best: Candidate, one: Candidate| match one.score > best.score {
        true => one,
        false => best,
    };
    words.reduce(larger).into_iter().collect()
}

fn is_off_the_ground(pose: &Pose, side: Side) -> bool {
    let [_, _, ankle, toe] = Role::leg(side);
    pose.clearance(ankle) >= STANDING[0] && pose.clearance(toe) >= STANDING[1]
}

fn leg(pose: &Pose, side: Side) -> Option<(PostureState, f64)> {
    let limb = Role::leg(side);
    let [hip, knee, ankle, _] = limb;
    if !is_off_the_ground(pose, side) {
        return best([(PostureState::Bent, (pose.bend(limb) + 0.35) / 0.8)]);
    }
    let reach = pose.reach(limb);
    let steepness = -unit(reach).dot(&pose.up);
    let thigh = unit(pose.at(knee) - pose.at(hip)).dot(&pose.up);
    let lift = (pose.clearance(ankle) - 0.2) / 0.3;
    let is_in_the_air = Side::BOTH
        .into_iter()
        .all(|side| is_off_the_ground(pose, side));
    let steep = if is_in_the_air { 0.85 } else { 0.75 };
    let telling = match reach.norm() > 0.8 {
        true => (PostureState::High, (steep - steepness) / 0.4),
        false => (PostureState::Raised, (thigh + 0.45) / 0.6),
    };
    // What the leg does says more than that its foot is off the ground.
    match best([telling]) {
        Some((state, score)) => Some((state, score.max(lift))),
        None => best([(PostureState::Lifted, lift)]),
    }
}

/// How two feet stand to each other, unless both are off the ground.
fn stance(pose: &Pose) -> Option<Candidate> {
    if Side::BOTH
        .into_iter()
        .all(|side| is_off_the_ground(pose, side))
    {
        return None;
    }
    let [left, forward] = pose.level_axes();
    let apart = pose.at(Role::LeftAnkle) - pose.at(Role::RightAnkle);
    let (sideways, ahead) = (apart.dot(&left), apart.dot(&forward));
    let front = match ahead > 0.0 {
        true => PosturePart::LeftLeg,
        false => PosturePart::RightLeg,
    };
    let words = [
        (front, PostureState::Forward, (ahead.abs() - 0.2) / 0.4),
        (
            PosturePart::BothLegs,
            PostureState::Apart,
            (sideways - 0.28) / 0.3,
        ),
        (
            PosturePart::BothLegs,
            PostureState::Crossed,
            (-sideways - 0.06) / 0.2,
        ),
    ];
    let fitting = words.into_iter().filter(|(_, _, score)| *score > 0.0);
    let best = fitting.reduce(|best, one| if one.2 > best.2 { one } else { best });
    best.map(|(part, state, score)| Candidate {
        word: PostureWord { part, state },
        score,
    })
}
