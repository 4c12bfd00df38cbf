//! Arms and legs by their names: on each side the chain of three joints that is named best.

use super::names::Part;
use super::reading::Reading;
use super::role::Side;
use super::tree::Tree;

/// Hip, knee, ankle, or shoulder, elbow, wrist.
pub type Limb = [usize; 3];

/// The parts of a leg.
pub const LEG: [Part; 3] = [Part::Hip, Part::Knee, Part::Ankle];

/// The parts of an arm.
pub const ARM: [Part; 3] = [Part::Shoulder, Part::Elbow, Part::Wrist];

/// A forearm below this share of the upper arm …
const SHIFTED_LOWER: f64 = 0.48;

/// … together with a clavicle above this share of it: the names are shifted by one.
const SHIFTED_UPPER: f64 = 0.7;

/// A joint and how well its name fits; ties go to the joint nearer to the root.
#[derive(Clone, Copy)]
struct Fit {
    joint: usize,
    strength: u8,
    depth: usize,
}

fn better(one: Option<Fit>, other: Option<Fit>) -> Option<Fit> {
    match (one, other) {
        (Some(one), Some(other)) => {
            let wins = (other.strength, one.depth) > (one.strength, other.depth);
            Some(if wins { other } else { one })
        }
        (one, other) => one.or(other),
    }
}

/// The best named chain of `parts` on `side`, each joint below the one before.
pub fn by_name(tree: &Tree, readings: &[Reading], side: Side, parts: [Part; 3]) -> Option<Limb> {
    let fit = |joint: usize, part: Part| {
        let reading = &readings[joint];
        let strength = match reading.side == Some(side) && reading.is_inner() {
            true => reading.strength(part),
            false => 0,
        };
        let depth = tree.depth(joint);
        (strength > 0).then_some(Fit {
            joint,
            strength,
            depth,
        })
    };
    let above = best_above(tree, |joint| fit(joint, parts[0]));
    let below = best_below(tree, |joint| {
        let named = fit(joint, parts[2]);
        let parent = tree.parent(joint).and_then(|parent| fit(parent, parts[1]));
        let ends_middle = tree.is_end_site(joint) && parent.is_some_and(|fit| fit.strength > 1);
        let depth = tree.depth(joint);
        named.or_else(|| {
            ends_middle.then_some(Fit {
                joint,
                strength: 1,
                depth,
            })
        })
    });
    let mut best: Option<(Fit, Limb)> = None;
    for joint in 0..tree.len() {
        let (Some(start), Some(middle), Some(end)) =
            (above[joint], fit(joint, parts[1]), below[joint])
        else {
            continue;
        };
        let whole = Fit {
            strength: start.strength + middle.strength + end.strength,
            ..middle
        };
        let limb = [start.joint, joint, end.joint];
        if best.is_none_or(|(fit, _)| (whole.strength, fit.depth) > (fit.strength, whole.depth)) {
            best = Some((whole, limb));
        }
    }
    best.map(|(_, limb)| limb)
}

/// For each joint the best fit strictly above it.
fn best_above(tree: &Tree, fit: impl Fn(usize) -> Option<Fit>) -> Vec<Option<Fit>> {
    let mut best = vec![None; tree.len()];
    for joint in 0..tree.len() {
        if let Some(parent) = tree.parent(joint) {
            best[joint] = better(best[parent], fit(parent));
        }
    }
    best
}

/// For each joint the best fit strictly below it.
fn best_below(tree: &Tree, fit: impl Fn(usize) -> Option<Fit>) -> Vec<Option<Fit>> {
    let mut best = vec![None; tree.len()];
    for joint in (0..tree.len()).rev() {
        if let Some(parent) = tree.parent(joint) {
            best[parent] = better(better(fit(joint), best[joint]), best[parent]);
        }
    }
    best
}

/// Moves both limbs one joint towards the root where their lengths say that the names are
/// shifted: a `LeftArm` at the elbow, a `LeftThigh` at the knee.
pub fn unshifted(tree: &Tree, readings: &[Reading], limbs: [Limb; 2]) -> Option<[Limb; 2]> {
    let mut moved = limbs;
    let (mut before, mut upper, mut lower) = (0.0, 0.0, 0.0);
    for (limb, moved) in limbs.iter().zip(&mut moved) {
        let [start, middle, end] = *limb;
        let first = tree.parent(start)?;
        if readings[first].side.is_none() || readings[first].side != readings[start].side {
            return None;
        }
        before += tree.path_length(first, start);
        upper += tree.path_length(start, middle);
        lower += tree.path_length(middle, end);
        *moved = [first, start, middle];
    }
    let is_shifted = lower < SHIFTED_LOWER * upper && before > SHIFTED_UPPER * upper;
    is_shifted.then_some(moved)
}
