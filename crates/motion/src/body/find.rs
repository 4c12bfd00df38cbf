//! The search: names, then the shape, then trunk and ends, each leaving what is there already.

use nalgebra::Vector3;

use super::draft::Draft;
use super::ends::{self, Ends};
use super::limbs::{self, Limb};
use super::names::Part;
use super::reading::{self, Reading};
use super::rest_pose::RestPose;
use super::tree::Tree;
use super::{Body, Role, Side, Source, mirrored, shape, sides, trunk};
use crate::clip::Clip;
use crate::kinematics::Kinematics;
use crate::note::{Note, NoteKind};

/// Frames, evenly spaced, that the search looks at where it needs the motion.
const SAMPLED_FRAMES: usize = 200;

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
        let found = limbs_by_shape(clip, performer, tree, readings, legs, arms);
        let [legs, arms] = found.map_or([None, None], |limbs| limbs.map(Some));
        draft.set_limbs(legs, arms, Source::Shape);
    }
}

/// Legs and arms with those that names did not tell by their shape, the left ones first.
fn limbs_by_shape(
    clip: &Clip,
    performer: usize,
    tree: &Tree,
    readings: &[Reading],
    legs: Option<[Limb; 2]>,
    arms: Option<[Limb; 2]>,
) -> Option<[[Limb; 2]; 2]> {
    let pairs = shape::pairs(tree);
    let (legs, arms) = match (legs, arms) {
        (None, None) => {
            let (legs, arms) = shape::legs_and_arms(tree, &pairs)?;
            (legs.limbs(tree, shape::LEG)?, arms.limbs(tree, shape::ARM)?)
        }
        (None, Some(arms)) => {
            let legs = shape::apart_from(tree, &pairs, arms)?;
            (legs.limbs(tree, shape::LEG)?, arms)
        }
        (Some(legs), _) => {
            let arms = shape::apart_from(tree, &pairs, legs)?;
            (legs, arms.limbs(tree, shape::ARM)?)
        }
    };
    let frame = first_places(clip, performer, tree.len());
    let places = sides::standing_places(tree, &frame, legs, arms)?;
    let ends = Ends {
        tree,
        readings,
        end_sites: true,
    };
    let toes = [ends.toe(legs[0][2]), ends.toe(legs[1][2])];
    let left = sides::left(places, legs, arms, toes);
    Some([legs, arms].map(|limbs| sides::sorted(readings, places, left, limbs)))
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
