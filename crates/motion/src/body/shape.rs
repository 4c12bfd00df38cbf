//! Arms and legs by their shape, where names fail: pairs of mirror-image chains that leave the
//! trunk, and on each the three joints whose bones have a person's proportions.

use super::limbs::Limb;
use super::tree::Tree;

/// A chain shorter than this share of the skeleton's size is no limb.
const LIMB_LENGTH: f64 = 0.25;

/// Mirror images differ by less than this share of their length, bone by bone.
const MIRROR: f64 = 0.15;

/// An End Site longer than this share of the skeleton's size is garbage.
const END_SITE_LENGTH: f64 = 0.2;

/// A bone shorter than this share of the skeleton's size is none.
const ZERO: f64 = 2e-3;

/// The weight of the way from the trunk to the limb, which often has a part of the trunk in it.
const BEFORE: f64 = 0.05;

/// The cost of a joint between the three of a limb.
const SKIPPED: f64 = 0.15;

/// Chains compared at one joint: the longest ones.
const COMPARED: usize = 32;

/// Joints looked at on a chain; no limb has more before its tip.
const LONGEST_CHAIN: usize = 40;

/// Proportions of a limb, in lengths of its two long bones together.
#[derive(Clone, Copy, Debug)]
pub struct Proportions {
    /// From the trunk to the limb's first joint.
    before: f64,
    /// The upper bone against the lower one.
    upper_per_lower: f64,
    /// From the limb's last joint to its tip.
    after: f64,
}

/// A leg: hips .057 to .1 H, thigh .263 H, shin .257 H, foot .11 H.
pub const LEG: Proportions = Proportions {
    before: 0.13,
    upper_per_lower: 1.02,
    after: 0.21,
};

/// An arm: clavicle .11 H, upper arm .169 H, forearm .151 H, hand .08 to .12 H.
pub const ARM: Proportions = Proportions {
    before: 0.35,
    upper_per_lower: 1.12,
    after: 0.35,
};

/// Two mirror-image chains.
#[derive(Clone, Debug, PartialEq)]
pub struct Pair {
    /// The joint that both leave.
    pub branch: usize,
    /// The joints of each from the trunk outwards, along its longest way.
    pub chains: [Vec<usize>; 2],
    /// The longer one's length from the branch to its tip.
    pub length: f64,
}

impl Pair {
    /// The limbs on both chains that come nearest to `proportions`.
    pub fn limbs(&self, tree: &Tree, proportions: Proportions) -> Option<[Limb; 2]> {
        let [one, other] = &self.chains;
        let limb = |chain| limb(tree, self.branch, chain, proportions);
        Some([limb(one)?, limb(other)?])
    }
}

/// The longest of `pairs` that has nothing in common with the limbs known.
pub fn apart_from<'a>(tree: &Tree, pairs: &'a [Pair], known: [Limb; 2]) -> Option<&'a Pair> {
    let is_apart = |pair: &&Pair| {
        let starts = pair.chains.iter().map(|chain| chain[0]);
        let meets = |start: usize, limb: &Limb| {
            tree.contains(start, limb[2]) || tree.contains(limb[0], start)
        };
        !starts
            .into_iter()
            .any(|start| known.iter().any(|limb| meets(start, limb)))
    };
    pairs.iter().find(is_apart)
}

/// All pairs of mirror-image chains that are not inside one another, the longest first.
pub fn pairs(tree: &Tree) -> Vec<Pair> {
    let reach = reaches(tree);
    let mut taken = vec![false; tree.len()];
    let mut found = Vec::new();
    for branch in 0..tree.len() {
        if let Some(parent) = tree.parent(branch) {
            taken[branch] |= taken[parent];
        }
        if taken[branch] {
            continue;
        }
        for pair in pairs_at(tree, &reach, branch) {
            for chain in &pair.chains {
                taken[chain[0]] = true;
            }
            found.push(pair);
        }
    }
    found.sort_by(|one, other| other.length.total_cmp(&one.length));
    found
}

/// For each joint the length of its longest way outwards, End Sites included.
fn reaches(tree: &Tree) -> Vec<f64> {
    let longest = END_SITE_LENGTH * tree.rest.size;
    let mut reach = vec![0.0_f64; tree.len()];
    for joint in (1..tree.len()).rev() {
        let own = tree.offset_length(joint);
        let is_garbage = tree.is_end_site(joint) && own > longest;
        if let Some(parent) = tree.parent(joint).filter(|_| !is_garbage) {
            reach[parent] = reach[parent].max(own + reach[joint]);
        }
    }
    reach
}

/// The joints from `start` outwards along the longest way.
fn chain(tree: &Tree, reach: &[f64], start: usize) -> Vec<usize> {
    let mut joints = vec![start];
    let mut at = start;
    let way = |joint: usize| tree.offset_length(joint) + reach[joint];
    while let Some(next) = tree
        .joints_below(at)
        .reduce(|best, joint| if way(joint) > way(best) { joint } else { best })
    {
        joints.push(next);
        at = next;
        if joints.len() == LONGEST_CHAIN {
            break;
        }
    }
    joints
}

fn pairs_at(tree: &Tree, reach: &[f64], branch: usize) -> Vec<Pair> {
    let length = |joint: usize| tree.offset_length(joint) + reach[joint];
    let mut starts: Vec<usize> = tree
        .joints_below(branch)
        .filter(|joint| length(*joint) >= LIMB_LENGTH * tree.rest.size)
        .collect();
    starts.sort_by(|one, other| length(*other).total_cmp(&length(*one)));
    starts.truncate(COMPARED);
    if starts.len() < 2 {
        return Vec::new();
    }
    starts.sort_unstable();
    let chains: Vec<_> = starts
        .iter()
        .map(|start| chain(tree, reach, *start))
        .collect();
    let mut candidates = Vec::new();
    for (index, one) in chains.iter().enumerate() {
        for other in &chains[index + 1..] {
            let longer = length(one[0]).max(length(other[0]));
            let difference = difference(tree, one, other) / longer;
            if one.len() > 2 && one.len() == other.len() && difference < MIRROR {
                candidates.push((difference, one, other, longer));
            }
        }
    }
    candidates.sort_by(|one, other| one.0.total_cmp(&other.0));
    let mut found: Vec<Pair> = Vec::new();
    for (_, one, other, length) in candidates {
        let is_used = |start: usize| {
            found
                .iter()
                .any(|pair| pair.chains.iter().any(|c| c[0] == start))
        };
        if !is_used(one[0]) && !is_used(other[0]) {
            found.push(Pair {
                branch,
                chains: [one.clone(), other.clone()],
                length,
            });
        }
    }
    found
}

/// The sum of the differences of the bones of two chains.
fn difference(tree: &Tree, one: &[usize], other: &[usize]) -> f64 {
    let bones = one.iter().zip(other);
    bones
        .map(|(one, other)| (tree.offset_length(*one) - tree.offset_length(*other)).abs())
        .sum()
}

/// The three joints of a chain that come nearest to `proportions`. The last of them stands at or
/// before the joint where the chain divides into fingers or toes.
fn limb(tree: &Tree, branch: usize, chain: &[usize], proportions: Proportions) -> Option<Limb> {
    let reach = reaches(tree);
    let last = *chain.last()?;
    let measured = Measured {
        lengths: chain
            .iter()
            .map(|joint| tree.path_length(branch, *joint))
            .collect(),
        zeros: chain
            .iter()
            .map(|joint| tree.rest.is_zero(*joint))
            .collect(),
        whole: tree.path_length(branch, last) + reach[last],
    };
    let divides = |joint: &usize| {
        let is_bone =
            |child: &usize| tree.offset_length(*child) + reach[*child] > ZERO * tree.rest.size;
        tree.joints_below(*joint).filter(is_bone).count() > 1
    };
    let hand = chain
        .iter()
        .skip(2)
        .position(divides)
        .map_or(chain.len(), |place| place + 3);
    let mut best: Option<(f64, [usize; 3])> = None;
    for first in 0..hand {
        for middle in first + 1..hand {
            for end in middle + 1..hand {
                let cost = measured.cost([first, middle, end], proportions);
                if cost.is_some_and(|cost| best.is_none_or(|(least, _)| cost < least)) {
                    best = cost.map(|cost| (cost, [first, middle, end]));
                }
            }
        }
    }
    best.map(|(_, places)| places.map(|place| chain[place]))
}

/// A chain in lengths from its branch.
struct Measured {
    lengths: Vec<f64>,
    zeros: Vec<bool>,
    whole: f64,
}

impl Measured {
    /// How far three joints of the chain are from `proportions`; none without two bones.
    fn cost(&self, [first, middle, end]: [usize; 3], proportions: Proportions) -> Option<f64> {
        let upper = self.lengths[middle] - self.lengths[first];
        let lower = self.lengths[end] - self.lengths[middle];
        if upper <= 0.0 || lower <= 0.0 {
            return None;
        }
        let bones = upper + lower;
        let before = self.lengths[first] / bones - proportions.before;
        let after = (self.whole - self.lengths[end]) / bones - proportions.after;
        let ratio = libm::log(upper / lower / proportions.upper_per_lower);
        let between = (first + 1..end).filter(|place| *place != middle && !self.zeros[*place]);
        let skipped = SKIPPED * between.count() as f64;
        Some(ratio * ratio + after * after + BEFORE * before * before + skipped)
    }
}

/// The legs and the arms among `pairs`: the two longest; the legs' branch stands above the arms',
/// or is the one from which nothing else leaves.
pub fn legs_and_arms<'a>(tree: &Tree, pairs: &'a [Pair]) -> Option<(&'a Pair, &'a Pair)> {
    let [one, other, ..] = pairs else {
        return None;
    };
    let is_legs = match (
        one.branch != other.branch && tree.contains(one.branch, other.branch),
        one.branch != other.branch && tree.contains(other.branch, one.branch),
    ) {
        (true, _) => true,
        (_, true) => false,
        _ => tree.joints_below(one.branch).count() <= tree.joints_below(other.branch).count(),
    };
    Some(if is_legs { (one, other) } else { (other, one) })
}
