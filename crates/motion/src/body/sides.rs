//! Which of two mirror-image limbs is the left one, by the pose.

use nalgebra::Vector3;

use super::limbs::Limb;
use super::reading::Reading;
use super::role::Side;
use super::tree::Tree;

/// The cosine below which legs hang down from the trunk.
const STANDING: f64 = -0.5;

/// The cosine above which a direction is along the line of the hips.
const ALONG_HIPS: f64 = 0.5;

/// Places to judge by: those of the rest pose if it is a standing body, else those of `frame`;
/// none if neither is.
pub fn standing_places<'a>(
    tree: &'a Tree,
    frame: &'a [Vector3<f64>],
    legs: [Limb; 2],
    arms: [Limb; 2],
) -> Option<&'a [Vector3<f64>]> {
    [tree.rest.places.as_slice(), frame]
        .into_iter()
        .find(|places| stands(places, legs, arms))
}

fn middle(places: &[Vector3<f64>], joints: [usize; 2]) -> Vector3<f64> {
    (places[joints[0]] + places[joints[1]]) / 2.0
}

fn stands(places: &[Vector3<f64>], legs: [Limb; 2], arms: [Limb; 2]) -> bool {
    let hips = middle(places, [legs[0][0], legs[1][0]]);
    let up = middle(places, [arms[0][0], arms[1][0]]) - hips;
    let down = middle(places, [legs[0][2], legs[1][2]]) - hips;
    let lengths = up.norm() * down.norm();
    lengths > 0.0 && up.dot(&down) <= STANDING * lengths
}

/// The two limbs with the left one first: by the sides in their names, else by the direction
/// `left`.
pub fn sorted(
    readings: &[Reading],
    places: &[Vector3<f64>],
    left: Vector3<f64>,
    limbs: [Limb; 2],
) -> [Limb; 2] {
    let named = limbs.map(|limb| readings[limb[0]].side);
    let is_swapped = match named {
        [Some(one), Some(other)] if one != other => one == Side::Right,
        _ => (places[limbs[0][0]] - places[limbs[1][0]]).dot(&left) < 0.0,
    };
    if is_swapped {
        [limbs[1], limbs[0]]
    } else {
        limbs
    }
}

/// The direction of the person's left: up × forward, up along the trunk, forward along the feet;
/// +X where that is across the line of the hips, for then the feet tell nothing.
pub fn left(
    places: &[Vector3<f64>],
    legs: [Limb; 2],
    arms: [Limb; 2],
    toes: [usize; 2],
) -> Vector3<f64> {
    let up = middle(places, [arms[0][0], arms[1][0]]) - middle(places, [legs[0][0], legs[1][0]]);
    let forward = middle(places, toes) - middle(places, [legs[0][2], legs[1][2]]);
    let left = up.cross(&forward);
    let hips = places[legs[0][0]] - places[legs[1][0]];
    let lengths = left.norm() * hips.norm();
    let is_along_hips = lengths > 0.0 && left.dot(&hips).abs() >= ALONG_HIPS * lengths;
    if is_along_hips { left } else { Vector3::x() }
}
