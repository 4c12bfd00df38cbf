//! Head, neck and pelvis, once arms and legs are known.

use super::limbs::Limb;
use super::names::Part;
use super::reading::Reading;
use super::tree::Tree;

/// The joint of the head: the head word nearest to the root, above the arms' branch before
/// anywhere else; without one the top of the longest chain without side from that branch.
pub fn head(tree: &Tree, readings: &[Reading], legs: [Limb; 2], arms: [Limb; 2]) -> Option<usize> {
    let branch = tree.common(arms[0][0], arms[1][0]);
    let limbs = [legs[0], legs[1], arms[0], arms[1]];
    let fits = |joint: &usize| {
        let reading = &readings[*joint];
        reading.side.is_none()
            && reading.is_inner()
            && reading.strength(Part::Head) > 0
            && !limbs.iter().any(|limb| meets(tree, *joint, *limb))
    };
    let named = (0..tree.len()).filter(fits);
    let best =
        named.min_by_key(|joint| (!tree.contains(branch, *joint), tree.depth(*joint), *joint));
    best.or_else(|| top(tree, readings, branch, arms, false))
        .or_else(|| top(tree, readings, branch, arms, true))
}

/// Whether a joint stands above or on a limb.
fn meets(tree: &Tree, joint: usize, limb: Limb) -> bool {
    tree.contains(joint, limb[2]) || tree.contains(limb[0], joint)
}

/// The last joint of the longest chain without side that leaves `branch` beside the arms; a chain
/// ends where it divides, for a face or hair begins there. A nose is a head only `with_face`.
fn top(
    tree: &Tree,
    readings: &[Reading],
    branch: usize,
    arms: [Limb; 2],
    with_face: bool,
) -> Option<usize> {
    let is_free = |joint: &usize| {
        let reading = &readings[*joint];
        let is_other = reading.side.is_some()
            || reading.is_helper
            || (reading.strength(Part::Face) > 0 && !with_face);
        !is_other && !arms.iter().any(|limb| meets(tree, *joint, *limb))
    };
    let mut best: Option<(f64, usize)> = None;
    for start in tree.joints_below(branch).filter(is_free) {
        let mut last = start;
        let mut below: Vec<usize> = tree.joints_below(last).filter(is_free).collect();
        while let [next] = below[..] {
            last = next;
            below = tree.joints_below(last).filter(is_free).collect();
        }
        let way = tree.path_length(branch, last);
        if best.is_none_or(|(length, _)| way > length) {
            best = Some((way, last));
        }
    }
    best.map(|(_, joint)| joint)
}

/// The pelvis: the lowest joint that carries both hips and the head.
pub fn pelvis(tree: &Tree, hips: [usize; 2], head: usize) -> usize {
    let common = tree.common(tree.common(hips[0], hips[1]), head);
    // A hip or the head is no pelvis: one chain all of whose joints stand on each other.
    let is_limb = hips.contains(&common) || common == head;
    match tree.parent(common) {
        Some(parent) if is_limb => parent,
        _ => common,
    }
}

/// The first neck joint with an offset on the way from the pelvis to the head; without a neck
/// word the first joint with an offset above the arms' branch. Where the head follows that branch
/// at once, the head's joint if it has a tip above it, else the branch.
pub fn neck(
    tree: &Tree,
    readings: &[Reading],
    pelvis: usize,
    head: usize,
    shoulders: [usize; 2],
) -> usize {
    let path = tree.path(pelvis, head);
    let has_offset = |joint: &&usize| !tree.rest.is_zero(**joint);
    let named = |least: u8| {
        let mut all = path.iter().filter(has_offset);
        all.find(|joint| {
            readings[**joint].is_inner() && readings[**joint].strength(Part::Neck) >= least
        })
    };
    if let Some(neck) = named(2).or_else(|| named(1)) {
        return *neck;
    }
    let branch = tree.common(shoulders[0], shoulders[1]);
    let above = tree.path(branch, head);
    let inner = above.iter().filter(|joint| **joint != head);
    let has_tip = tree
        .children(head)
        .iter()
        .any(|child| !tree.rest.is_zero(*child));
    match inner.copied().find(|joint| !tree.rest.is_zero(*joint)) {
        Some(neck) => neck,
        None if !has_tip && branch != pelvis && tree.contains(pelvis, branch) => branch,
        None => head,
    }
}
