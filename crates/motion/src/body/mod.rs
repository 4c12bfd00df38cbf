//! The body: a skeleton goes in, and which of its joints are the principal ones comes out.
//!
//! Names first, looked up in the tables of [`names`]; the shape where they fail; a person's
//! corrections above both. The rules and how to add a rig: `docs/body.md`.

mod draft;
mod ends;
mod human;
mod limbs;
mod mirrored;
pub mod names;
mod pelvis_frame;
mod reading;
mod rest_pose;
mod role;
mod shape;
mod sides;
mod table;
mod tokens;
mod tree;
mod trunk;

pub use pelvis_frame::PelvisFrame;
pub use role::{PRINCIPAL_JOINTS, Role, Side};
pub use table::{PoseTable, TableBuilder};

use nalgebra::Vector3;

use crate::clip::Clip;
use crate::kinematics::Kinematics;
use crate::note::{Note, NoteKind};
use crate::track::PelvisTrack;
use draft::Draft;
use ends::Ends;
use limbs::Limb;
use names::Part;
use reading::Reading;
use rest_pose::RestPose;
use tree::Tree;

/// Frames, evenly spaced, that the search looks at where it needs the motion.
const SAMPLED_FRAMES: usize = 200;

/// Why a joint was taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// Its name.
    Name,
    /// The shape of the skeleton.
    Shape,
    /// A person chose it.
    User,
    /// An end that is missing: its parent stands for it.
    Fallback,
}

/// Which joint takes a role, and why.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BodyJoint {
    /// The place of the body.
    pub role: Role,
    /// The joint's index in the skeleton.
    pub joint: usize,
    /// Why it was taken.
    pub source: Source,
}

/// Whether the skeleton is a person.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Two legs, two arms and a head.
    Human,
    /// Anything else.
    Other {
        /// What it lacks, e.g. `no two arms`.
        missing: Vec<&'static str>,
    },
}

/// The body found in one performer's skeleton.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Whether it is a person.
    pub kind: Kind,
    /// The pelvis joint; the root where the body is not human.
    pub pelvis: usize,
    /// The left and the right hip; the root where the body is not human.
    pub hips: [usize; 2],
    /// The joints in the order of [`Role::ALL`]: the 16 principal ones, pelvis and hips in a human, as many
    /// of them as were found in any other body.
    pub joints: Vec<BodyJoint>,
    /// What was assumed.
    pub notes: Vec<Note>,
}

impl Body {
    /// Whether it is a person.
    pub fn is_human(&self) -> bool {
        self.kind == Kind::Human
    }

    /// The joint of a role, if it was found.
    pub fn joint(&self, role: Role) -> Option<usize> {
        let found = self.joints.iter().find(|joint| joint.role == role);
        found.map(|joint| joint.joint)
    }

    /// The joints that the analysis follows: the 16 principal ones, or all (End Sites left out)
    /// where the body is not human.
    pub fn analysed(&self, clip: &Clip, performer: usize) -> Vec<usize> {
        if self.is_human() {
            return self.joints[..PRINCIPAL_JOINTS]
                .iter()
                .map(|joint| joint.joint)
                .collect();
        }
        let joints = &clip.performers[performer].skeleton.joints;
        (0..joints.len())
            .filter(|joint| !joints[*joint].is_end_site)
            .collect()
    }
}

/// Finds the body of one performer (from 0).
///
/// `overrides` are a person's choices (role, index of the joint); an index that the skeleton does
/// not have is ignored.
pub fn find(clip: &Clip, performer: usize, overrides: &[(Role, usize)]) -> Body {
    let skeleton = &clip.performers[performer].skeleton;
    let step = clip.frames / SAMPLED_FRAMES + 1;
    let tree = Tree::new(skeleton, RestPose::new(clip, performer, 0, step));
    let readings = reading::read(skeleton);
    let mut draft = Draft::new(overrides, tree.len());
    let mut notes = Vec::new();
    find_limbs(clip, performer, &tree, &readings, &mut draft, &mut notes);
    find_trunk(&tree, &readings, &mut draft);
    find_ends(&tree, &readings, &mut draft, &mut notes);
    let body = draft.finish(&readings, notes, !overrides.is_empty());
    mirrored::noted(clip, performer, body, step)
}

fn find_limbs(
    clip: &Clip,
    performer: usize,
    tree: &Tree,
    readings: &[Reading],
    draft: &mut Draft,
    notes: &mut Vec<Note>,
) {
    let named = |parts| {
        let [left, right] = Side::BOTH.map(|side| limbs::by_name(tree, readings, side, parts));
        left.zip(right).map(|(left, right)| [left, right])
    };
    let mut legs = named(limbs::LEG);
    let mut arms = named(limbs::ARM);
    for (limbs, kind) in [
        (&mut legs, NoteKind::ShiftedLegNames),
        (&mut arms, NoteKind::ShiftedArmNames),
    ] {
        if let Some(moved) = limbs.and_then(|limbs| limbs::unshifted(tree, readings, limbs)) {
            *limbs = Some(moved);
            notes.push(Note::new(kind, Vec::new()));
        }
    }
    draft.set_limbs(legs, arms, Source::Name);
    if legs.is_none() || arms.is_none() {
        let (legs, arms) = limbs_by_shape(clip, performer, tree, readings, legs, arms);
        draft.set_limbs(legs, arms, Source::Shape);
    }
}

/// The limbs that names did not tell, by their shape.
fn limbs_by_shape(
    clip: &Clip,
    performer: usize,
    tree: &Tree,
    readings: &[Reading],
    legs: Option<[Limb; 2]>,
    arms: Option<[Limb; 2]>,
) -> (Option<[Limb; 2]>, Option<[Limb; 2]>) {
    let pairs = shape::pairs(tree);
    let limbs = |pair: &shape::Pair, proportions| {
        let [one, other] = &pair.chains;
        let limb = |chain| shape::limb(tree, pair.branch, chain, proportions);
        limb(one).zip(limb(other)).map(|(one, other)| [one, other])
    };
    let free = |taken: [Limb; 2]| {
        let is_free = |pair: &&shape::Pair| {
            let starts = pair.chains.iter().map(|chain| chain[0]);
            starts
                .clone()
                .all(|start| taken.iter().all(|limb| !tree.contains(start, limb[2])))
                && starts
                    .clone()
                    .all(|start| taken.iter().all(|limb| !tree.contains(limb[0], start)))
        };
        pairs.iter().find(is_free)
    };
    let (found_legs, found_arms) = match (legs, arms) {
        (Some(legs), _) => (
            Some(legs),
            free(legs).and_then(|pair| limbs(pair, shape::ARM)),
        ),
        (_, Some(arms)) => (
            free(arms).and_then(|pair| limbs(pair, shape::LEG)),
            Some(arms),
        ),
        _ => match shape::legs_and_arms(tree, &pairs) {
            Some((legs, arms)) => (limbs(legs, shape::LEG), limbs(arms, shape::ARM)),
            None => (None, None),
        },
    };
    let (Some(found_legs), Some(found_arms)) = (found_legs, found_arms) else {
        return (None, None);
    };
    let frame = first_places(clip, performer, tree.len());
    let Some(places) = sides::standing_places(tree, &frame, found_legs, found_arms) else {
        return (None, None);
    };
    let ends = Ends {
        tree,
        readings,
        end_sites: true,
    };
    let toes = ends::of_both(found_legs, |ankle| ends.toe(ankle));
    let left = sides::left(places, found_legs, found_arms, toes);
    let sorted = |limbs| Some(sides::sorted(readings, places, left, limbs));
    (sorted(found_legs), sorted(found_arms))
}

/// Where the joints stand in the world in frame 0.
fn first_places(clip: &Clip, performer: usize, joints: usize) -> Vec<Vector3<f64>> {
    let mut positions = vec![0.0; 3 * joints];
    if clip.frames > 0 {
        Kinematics::new(clip, performer).positions(0, &mut positions);
    }
    positions
        .chunks_exact(3)
        .map(Vector3::from_column_slice)
        .collect()
}

fn find_trunk(tree: &Tree, readings: &[Reading], draft: &mut Draft) {
    let (Some(legs), Some(arms)) = (draft.legs(), draft.arms()) else {
        return;
    };
    let chosen = draft.joint(Role::Head);
    let head = chosen.or_else(|| trunk::head(tree, readings, legs, arms));
    let Some(mut head) = head else {
        return;
    };
    if tree.is_end_site(head) {
        head = tree.parent(head).unwrap_or(head);
    }
    let source = |joint: usize, part: Part| match readings[joint].strength(part) {
        0 => Source::Shape,
        _ => Source::Name,
    };
    draft.head = Some((head, source(head, Part::Head)));
    let pelvis = trunk::pelvis(tree, [legs[0][0], legs[1][0]], head);
    draft.set(Role::Pelvis, pelvis, source(pelvis, Part::Pelvis));
    let pelvis = draft.joint(Role::Pelvis).unwrap_or(0);
    let neck = trunk::neck(tree, readings, pelvis, head, [arms[0][0], arms[1][0]]);
    draft.set(Role::Neck, neck, source(neck, Part::Neck));
}

fn find_ends(tree: &Tree, readings: &[Reading], draft: &mut Draft, notes: &mut Vec<Note>) {
    let unnamed = [draft.legs(), draft.arms()].into_iter().flatten();
    let mut unnamed = unnamed.filter(|[left, _]| readings[left[0]].side.is_none());
    let end_sites = ends::end_sites_agree(tree, readings)
        && unnamed.all(|limbs| ends::limb_ends_agree(tree, limbs));
    if !end_sites {
        notes.push(Note::new(NoteKind::EndSitesUnequal, Vec::new()));
    }
    let ends = Ends {
        tree,
        readings,
        end_sites,
    };
    for side in Side::BOTH {
        let [_, _, wrist, finger] = Role::arm(side);
        let [_, _, ankle, toe] = Role::leg(side);
        draft.set_end(finger, draft.found(wrist), |joint| ends.finger(joint));
        draft.set_end(toe, draft.found(ankle), |joint| ends.toe(joint));
    }
    draft.set_end(Role::Head, draft.head, |joint| ends.head_tip(joint));
    notes.extend(draft.fallback_notes(tree.skeleton));
}

/// Follows one performer's body through the motion: its joints in pelvis coordinates from `first_frame` on.
pub fn track(
    clip: &Clip,
    performer: usize,
    body: &Body,
    frame: &PelvisFrame,
    first_frame: usize,
) -> PelvisTrack {
    let mut builder = TableBuilder::new(clip, performer, body);
    builder.step(clip.frames);
    builder.finish().into_track(frame, first_frame)
}
