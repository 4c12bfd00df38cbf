//! The ends of the body: fingers, toes and the tip of the head.

use super::limbs::Limb;
use super::names::Part;
use super::reading::Reading;
use super::role::Side;
use super::tree::Tree;

/// An End Site shorter than this share of the skeleton's size is a placeholder.
const PLACEHOLDER: f64 = 2e-3;

/// An End Site whose length is that of the bone before, within this share, repeats it.
const REPETITION: f64 = 2e-3;

/// Mirrored End Sites that differ by more than this factor …
const UNEQUAL: f64 = 1.5;

/// … with one above this share of the skeleton's size (0.08 body heights): they are garbage.
const UNEQUAL_LENGTH: f64 = 0.095;

/// The cosine above which a bone goes on in the direction of the one before.
const GOES_ON: f64 = 0.85;

/// What the ends are looked for with.
#[derive(Clone, Copy, Debug)]
pub struct Ends<'a> {
    /// The skeleton.
    pub tree: &'a Tree<'a>,
    /// What its names say.
    pub readings: &'a [Reading],
    /// Whether this file's End Sites are of use at all.
    pub end_sites: bool,
}

/// Whether the End Sites of left and right agree, by the names of their joints.
pub fn end_sites_agree(tree: &Tree, readings: &[Reading]) -> bool {
    let sites = |side: Side| {
        (0..tree.len())
            .filter(move |joint| tree.is_end_site(*joint))
            .filter_map(move |joint| {
                let parent = &readings[tree.parent(joint)?];
                (parent.side == Some(side))
                    .then(|| (parent.stem.as_str(), tree.offset_length(joint)))
            })
    };
    let right: std::collections::BTreeMap<&str, f64> = sites(Side::Right).collect();
    sites(Side::Left).all(|(stem, left)| {
        right
            .get(stem)
            .is_none_or(|right| lengths_agree(tree, left, *right))
    })
}

/// Whether the End Sites below both limbs of a pair agree, where the limbs are built alike.
pub fn limb_ends_agree(tree: &Tree, limbs: [Limb; 2]) -> bool {
    let [one, other] = limbs.map(|limb| tree.subtree(limb[0]));
    let is_alike = one.len() == other.len();
    let pairs = || one.iter().zip(&other);
    let are_sites = pairs().all(|(one, other)| tree.is_end_site(*one) == tree.is_end_site(*other));
    !is_alike
        || !are_sites
        || pairs()
            .filter(|(one, _)| tree.is_end_site(**one))
            .all(|(one, other)| {
                lengths_agree(tree, tree.offset_length(*one), tree.offset_length(*other))
            })
}

fn lengths_agree(tree: &Tree, one: f64, other: f64) -> bool {
    let (short, long) = (one.min(other), one.max(other));
    long <= UNEQUAL * short || long <= UNEQUAL_LENGTH * tree.rest.size
}

/// How well an end fits: rank, and reach from the joint that it ends.
type Fit = (u8, f64);

impl Ends<'_> {
    /// The End Site of a joint, if it is of use.
    fn end_site(&self, joint: usize) -> Option<usize> {
        let tree = self.tree;
        let bone = tree.offset_length(joint);
        let of_use = |site: &usize| {
            let length = tree.offset_length(*site);
            let repeats = (length - bone).abs() <= REPETITION * bone;
            tree.is_end_site(*site) && length >= PLACEHOLDER * tree.rest.size && !repeats
        };
        let mut children = tree.children(joint).iter().copied();
        children.find(of_use).filter(|_| self.end_sites)
    }

    /// The toe below an ankle; the ankle itself where there is none.
    pub fn toe(&self, ankle: usize) -> usize {
        let is_out = |joint: usize| self.readings[joint].strength(Part::Heel) > 0;
        let first = |joint: usize| self.readings[joint].numbers.first().copied();
        let below = self.leaves(ankle, is_out);
        let lowest = below.iter().filter_map(|leaf| first(*leaf)).min();
        let rank = |leaf: usize| {
            let big = u8::from(first(leaf).is_some() && first(leaf) == lowest);
            2 * self.readings[leaf].strength(Part::Toe) + big
        };
        self.best(ankle, &below, rank)
    }

    /// The finger below a wrist; the wrist itself where there is none.
    pub fn finger(&self, wrist: usize) -> usize {
        let numbers = self.finger_numbers(wrist);
        let of = |joint: usize, part: Part| self.readings[joint].strength(part) > 0;
        let number = |joint: usize| self.finger_number(joint);
        let is_out = |joint: usize| {
            of(joint, Part::Thumb) || (numbers.thumb.is_some() && number(joint) == numbers.thumb)
        };
        let rank = |leaf: usize| {
            let way = self.tree.path(wrist, leaf);
            let is_middle = way.iter().any(|joint| {
                of(*joint, Part::MiddleFinger)
                    || (numbers.middle.is_some() && number(*joint) == numbers.middle)
            });
            u8::from(is_middle)
        };
        self.best(wrist, &self.leaves(wrist, is_out), rank)
    }

    /// The tip of the head: a child called so, or one at the end that goes on where the neck points,
    /// else the End Site, else the head itself.
    pub fn head_tip(&self, head: usize) -> usize {
        let tree = self.tree;
        let is_tip = |child: &usize| {
            let reading = &self.readings[*child];
            let is_face = reading.strength(Part::Face) > 0 || reading.side.is_some();
            let is_named = reading.is_tip || self.goes_on(*child);
            is_named && !reading.is_helper && !is_face && !tree.rest.is_zero(*child)
        };
        let named = tree.joints_below(head).find(is_tip);
        named.or_else(|| self.end_site(head)).unwrap_or(head)
    }

    /// Whether a joint with nothing below it goes on in the direction of the bone before.
    fn goes_on(&self, joint: usize) -> bool {
        let offsets = &self.tree.rest.offsets;
        let Some(parent) = self.tree.parent(joint).filter(|_| self.is_leaf(joint)) else {
            return false;
        };
        let (before, own) = (offsets[parent], offsets[joint]);
        before.dot(&own) >= GOES_ON * before.norm() * own.norm()
    }

    fn is_leaf(&self, joint: usize) -> bool {
        self.tree.joints_below(joint).next().is_none()
    }

    /// The joints at the ends of the chains below `above`, `above` itself if nothing is below.
    fn leaves(&self, above: usize, is_out: impl Fn(usize) -> bool) -> Vec<usize> {
        let mut leaves = Vec::new();
        let mut open = vec![above];
        while let Some(joint) = open.pop() {
            let before = open.len();
            open.extend(
                self.tree
                    .joints_below(joint)
                    .filter(|child| !is_out(*child) && !self.is_bare_helper(*child)),
            );
            if open.len() == before {
                leaves.push(joint);
            }
        }
        leaves
    }

    /// Whether a joint is a helper with nothing below it.
    fn is_bare_helper(&self, joint: usize) -> bool {
        self.readings[joint].is_helper && self.is_leaf(joint)
    }

    /// Of the `leaves` below `above`, or their End Sites, the one of the highest rank, then of the
    /// farthest reach.
    fn best(&self, above: usize, leaves: &[usize], rank: impl Fn(usize) -> u8) -> usize {
        let mut best: (Fit, usize) = ((0, PLACEHOLDER * self.tree.rest.size), above);
        for &leaf in leaves {
            let end = self.end_site(leaf).unwrap_or(leaf);
            let reach = self.reach(above, leaf);
            let is_placeholder = reach < PLACEHOLDER * self.tree.rest.size;
            if !is_placeholder && (rank(leaf), reach) > best.0 {
                best = ((rank(leaf), reach), end);
            }
        }
        best.1
    }

    /// How far a leaf reaches from `above`, with an End Site that may repeat the bone before.
    fn reach(&self, above: usize, leaf: usize) -> f64 {
        let sites = self.tree.children(leaf).iter().filter(|_| self.end_sites);
        let tips = sites.chain(core::iter::once(&leaf));
        let ways = tips.map(|tip| (self.tree.place(*tip) - self.tree.place(above)).norm());
        ways.fold(0.0, f64::max)
    }

    /// The number of the finger that a joint belongs to: that of the first joint of its chain.
    fn finger_number(&self, joint: usize) -> Option<u32> {
        let is_finger = |joint: &usize| self.readings[*joint].word.starts_with("finger");
        let first = self.tree.upwards(joint).take_while(is_finger).last()?;
        self.readings[first].numbers.first().copied()
    }

    /// Which numbers the thumb and the middle finger have, where fingers are numbered.
    fn finger_numbers(&self, wrist: usize) -> FingerNumbers {
        let all = self.tree.subtree(wrist).into_iter().skip(1);
        let mut numbers: Vec<u32> = all.filter_map(|joint| self.finger_number(joint)).collect();
        numbers.sort_unstable();
        numbers.dedup();
        let (thumb, middle) = match numbers.as_slice() {
            [0, _, ..] => (Some(0), Some(2)),
            [1, _, _, _, ..] => (Some(1), Some(3)),
            _ => (None, None),
        };
        FingerNumbers { thumb, middle }
    }
}

#[derive(Clone, Copy)]
struct FingerNumbers {
    thumb: Option<u32>,
    middle: Option<u32>,
}
