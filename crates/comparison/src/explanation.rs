//! Why two clips differ: their features and the joints' parts in; shares of the squared distance by
//! component, joint and part of the body, and what a sentence says of them, out.
//!
//! Component k has the share `s_k = (F_a,k − F_b,k)² / d²`; joint j, which adds m_k(j) to F_k, has
//! `Σ_k (F_a,k − F_b,k)(m_a,k(j) − m_b,k(j)) / d²`. Both sum up to 1; a joint's may be negative.

use crate::distance::{Distance, Measured, mirror, mirror_by_joint};
use crate::feature::{ClipFeature, FEATURE_LENGTH, JOINTS, PART_OF_JOINT, PARTS, Vector};

/// Components of one posture's covariance: σ_xx, σ_yy, σ_zz, σ_xy, σ_yz, σ_zx.
const COMPONENTS: usize = FEATURE_LENGTH / 2;

/// Clips nearer than this (in squared body heights) are the same.
const SAME: f64 = 1e-9;

/// The share from which on one number stands for the difference.
const OUTSTANDING_SHARE: f64 = 0.4;

/// The share above which a part of the body is named.
const NAMED_PART: f64 = 0.3;

/// Why two clips differ, a and b in the order asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Explanation {
    /// Their distance; where it is that to the mirror image, all below speaks of the mirrored b.
    pub distance: Measured,
    /// The share of each number of the feature; zeros where the distance is 0.
    pub shares: [f64; FEATURE_LENGTH],
    /// The share of each part of the body, negative where it makes them more alike.
    pub part_shares: [f64; PARTS],
    /// The share of each joint.
    pub joint_shares: [f64; JOINTS],
    /// What is worth saying.
    pub sentence: Sentence,
}

/// What is said of a difference; parts are those above 30 %, the largest first.
#[derive(Clone, Debug, PartialEq)]
pub enum Sentence {
    /// There is none.
    Same,
    /// No number makes 40 % of it.
    Everything {
        /// Indices of parts.
        parts: Vec<usize>,
    },
    /// One number outweighs the others.
    Component {
        /// Of σ_xx, σ_yy, σ_zz, σ_xy, σ_yz, σ_zx, from 0.
        component: usize,
        /// Which of its two numbers it is.
        of: Half,
        /// The share of the component, mean and deviation together.
        share: f64,
        /// In which clip the number is larger; of covariances, which have a sign, the larger size
        /// counts.
        larger: Which,
        /// Indices of parts.
        parts: Vec<usize>,
    },
}

/// The halves of a feature.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Half {
    /// The mean over the frames.
    Mean,
    /// The standard deviation over the frames.
    Deviation,
}

/// One of two clips.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Which {
    /// The first.
    A,
    /// The second.
    B,
}

/// Why `a` and `b` are as far from each other as `distance` says.
pub fn explain(distance: Distance, a: &ClipFeature, b: &ClipFeature) -> Explanation {
    let measured = distance.between(a, b);
    let (a_vector, a_joints) = (distance.vector(a), distance.by_joint(a));
    let (mut b_vector, mut b_joints) = (*distance.vector(b), *distance.by_joint(b));
    if measured.mirrored {
        b_vector = mirror(&b_vector);
        b_joints = mirror_by_joint(&b_joints);
    }
    let difference = minus(a_vector, &b_vector);
    let square = difference
        .iter()
        .fold(0.0, |sum, value| sum + value * value);
    let share = |value: f64| if square > 0.0 { value / square } else { 0.0 };
    let shares = difference.map(|value| share(value * value));
    let joint_shares: [f64; JOINTS] = core::array::from_fn(|joint| {
        let part = minus(&a_joints[joint], &b_joints[joint]);
        let products = difference.iter().zip(&part);
        share(products.fold(0.0, |sum, (whole, part)| sum + whole * part))
    });
    let part_shares = part_shares(&joint_shares);
    Explanation {
        distance: measured,
        sentence: match measured.value < SAME {
            true => Sentence::Same,
            false => sentence(&shares, named_parts(&part_shares), a_vector, &b_vector),
        },
        shares,
        part_shares,
        joint_shares,
    }
}

fn minus(a: &Vector, b: &Vector) -> Vector {
    core::array::from_fn(|index| a[index] - b[index])
}

fn part_shares(joint_shares: &[f64; JOINTS]) -> [f64; PARTS] {
    let mut shares = [0.0; PARTS];
    for (part, share) in PART_OF_JOINT.iter().zip(joint_shares) {
        shares[*part] += share;
    }
    shares
}

/// The parts worth naming, the largest first, of equals the earlier.
fn named_parts(shares: &[f64; PARTS]) -> Vec<usize> {
    let mut parts: Vec<usize> = (0..PARTS)
        .filter(|part| shares[*part] > NAMED_PART)
        .collect();
    parts.sort_by(|one, other| shares[*other].total_cmp(&shares[*one]));
    parts
}

fn sentence(shares: &Vector, parts: Vec<usize>, a: &Vector, b: &Vector) -> Sentence {
    let largest = (1..FEATURE_LENGTH).fold(0, |best, index| match shares[index] > shares[best] {
        true => index,
        false => best,
    });
    if shares[largest] < OUTSTANDING_SHARE {
        return Sentence::Everything { parts };
    }
    let component = largest % COMPONENTS;
    Sentence::Component {
        component,
        of: match largest < COMPONENTS {
            true => Half::Mean,
            false => Half::Deviation,
        },
        share: shares[component] + shares[component + COMPONENTS],
        larger: match a[largest].abs() > b[largest].abs() {
            true => Which::A,
            false => Which::B,
        },
        parts,
    }
}

#[cfg(test)]
mod tests;
