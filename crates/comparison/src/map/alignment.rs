//! A map laid onto an earlier one: a map and the old places of some of its items in, the same map,
//! turned, mirrored and moved, out.

use super::{Map, Place};

/// The map turned, mirrored if that fits better, and moved, but not scaled, so that the items of
/// `known` (item, old place) lie as near to their old places as can be (Procrustes; least squares).
/// Without any it stays as it is.
#[must_use]
pub fn procrustes(map: &Map, known: &[(usize, Place)]) -> Map {
    if known.is_empty() {
        return map.clone();
    }
    let new: Vec<Place> = known.iter().map(|(item, _)| map.places[*item]).collect();
    let old: Vec<Place> = known.iter().map(|(_, place)| *place).collect();
    let (new_middle, old_middle) = (middle(&new), middle(&old));
    let turn = best_turn(&new, new_middle, &old, old_middle);
    let moved = |place: &Place| {
        let from = minus(*place, new_middle);
        [0, 1].map(|axis| turn[axis][0] * from[0] + turn[axis][1] * from[1] + old_middle[axis])
    };
    Map {
        places: map.places.iter().map(moved).collect(),
        ..map.clone()
    }
}

/// The rows of the rotation, or reflection, that brings `new` nearest to `old`; no turn where every
/// one is as good.
fn best_turn(new: &[Place], new_middle: Place, old: &[Place], old_middle: Place) -> [Place; 2] {
    let mut sums = [[0.0; 2]; 2];
    for (new, old) in new.iter().zip(old) {
        let (new, old) = (minus(*new, new_middle), minus(*old, old_middle));
        for (row, old) in sums.iter_mut().zip(old) {
            row[0] += old * new[0];
            row[1] += old * new[1];
        }
    }
    let [[xx, xy], [yx, yy]] = sums;
    let (turned, mirrored) = ([xx + yy, yx - xy], [xx - yy, yx + xy]);
    let (turned_fit, mirrored_fit) = (length(turned), length(mirrored));
    let unit = |of: Place, length: f64| of.map(|value| value / length);
    if mirrored_fit > turned_fit {
        let [cosine, sine] = unit(mirrored, mirrored_fit);
        return [[cosine, sine], [sine, -cosine]];
    }
    match turned_fit > 0.0 {
        true => {
            let [cosine, sine] = unit(turned, turned_fit);
            [[cosine, -sine], [sine, cosine]]
        }
        false => [[1.0, 0.0], [0.0, 1.0]],
    }
}

pub(super) fn middle(places: &[Place]) -> Place {
    let mut sums = [0.0; 2];
    for place in places {
        sums[0] += place[0];
        sums[1] += place[1];
    }
    sums.map(|sum| sum / places.len().max(1) as f64)
}

pub(super) fn minus(one: Place, other: Place) -> Place {
    [one[0] - other[0], one[1] - other[1]]
}

fn length(place: Place) -> f64 {
    (place[0] * place[0] + place[1] * place[1]).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLACES: [Place; 4] = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [-2.0, 5.0]];

    fn map(places: &[Place]) -> Map {
        Map {
            places: places.to_vec(),
            spread: 0.5,
            squares_from_middle: vec![1.0; places.len()],
        }
    }

    fn assert_near(found: &[Place], expected: &[Place]) {
        for (found, expected) in found.iter().zip(expected) {
            assert!(
                length(minus(*found, *expected)) < 1e-14,
                "{found:?} {expected:?}"
            );
        }
    }

    #[test]
    fn a_turned_a_mirrored_and_a_moved_map_come_back() {
        let turns: [fn(Place) -> Place; 3] = [
            |[x, y]| [0.6 * x - 0.8 * y + 7.0, 0.8 * x + 0.6 * y - 2.0],
            |[x, y]| [x + 1.0, 4.0 - y],
            |[x, y]| [y, x],
        ];
        for turn in turns {
            let old = PLACES.map(turn);
            let known: Vec<(usize, Place)> = old.into_iter().enumerate().collect();
            assert_near(&procrustes(&map(&PLACES), &known).places, &old);
            // Three of them say where the fourth goes.
            assert_near(&procrustes(&map(&PLACES), &known[..3]).places, &old);
        }
    }

    #[test]
    fn a_larger_map_keeps_its_size() {
        let known: Vec<(usize, Place)> = PLACES
            .iter()
            .map(|[x, y]| [2.0 * x, 2.0 * y])
            .enumerate()
            .collect();
        let found = procrustes(&map(&PLACES), &known).places;
        assert!((length(minus(found[1], found[0])) - 3.0).abs() < 1e-14);
    }

    #[test]
    fn one_known_item_moves_the_map_and_none_leaves_it() {
        let found = procrustes(&map(&PLACES), &[(1, [10.0, 10.0])]).places;
        assert_near(
            &found,
            &[[7.0, 10.0], [10.0, 10.0], [10.0, 11.0], [5.0, 15.0]],
        );
        assert_eq!(procrustes(&map(&PLACES), &[]), map(&PLACES));
    }
}
