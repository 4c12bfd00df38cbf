//! A map that stays while clips arrive: the distances it was made of go in, the place of a further clip
//! comes out. What lies there does not move for it.

use crate::distance::Distance;
use crate::distances::Distances;
use crate::feature::ClipFeature;
use crate::map::{Map, Place, gower_place};

/// Clips laid out in the plane by one distance.
pub struct Layout {
    distance: Distance,
    distances: Distances,
    map: Map,
}

impl Layout {
    /// The map of the items that have these distances.
    pub fn new(distance: Distance, distances: Distances, map: Map) -> Self {
        Self {
            distance,
            distances,
            map,
        }
    }

    /// The distance by which the clips lie as they do.
    pub fn distance(&self) -> Distance {
        self.distance
    }

    /// The map.
    pub fn map(&self) -> &Map {
        &self.map
    }

    /// Where one more clip lies, by its distances to all that were laid out (Gower 1968).
    pub fn place(&self, clip: &ClipFeature) -> Place {
        let distances = self.distances.from_vector(self.distance.vector(clip));
        gower_place(&self.map, &distances)
    }
}

#[cfg(test)]
mod tests {
    use std::rc::Rc;

    use super::*;
    use crate::distance::Dissimilarity;
    use crate::feature::{FEATURE_LENGTH, JOINTS, Vector};
    use crate::map::{of_matrix, of_vectors, procrustes};
    use crate::{comparison::Comparison, settings::Settings};

    fn clip(recorded: Vector) -> Rc<ClipFeature> {
        Rc::new(ClipFeature {
            recorded,
            across_rigs: recorded.map(|value| 2.0 * value),
            recorded_by_joint: [[0.0; FEATURE_LENGTH]; JOINTS],
            across_rigs_by_joint: [[0.0; FEATURE_LENGTH]; JOINTS],
        })
    }

    /// Clips in the plane of two components, a third one apart from it.
    fn clips() -> Vec<Rc<ClipFeature>> {
        let places = [[0.0, 0.0], [2.0, 0.1], [0.3, 1.0], [3.0, 3.0], [-1.0, 2.0]];
        let vector = |[x, y]: Place| {
            let mut vector = [0.0; FEATURE_LENGTH];
            (vector[1], vector[3]) = (x, y);
            vector
        };
        places.map(vector).map(clip).to_vec()
    }

    fn distance(across_rigs: bool, mirror_aware: bool) -> Distance {
        Distance::PostureVariation(Dissimilarity {
            across_rigs,
            mirror_aware,
        })
    }

    fn is_near(found: Place, expected: Place) -> bool {
        (0..2).all(|axis| (found[axis] - expected[axis]).abs() < 1e-12)
    }

    /// The map of vectors is their projection, so one more vector lies where its projection does.
    #[test]
    fn a_clip_that_was_laid_out_comes_to_its_own_place() {
        for across_rigs in [false, true] {
            let distance = distance(across_rigs, false);
            let map = of_vectors(
                Distances::of(distance, &clips())
                    .vectors()
                    .expect("vectors"),
            );
            let turned = [[5.0, 1.0], [5.0, 3.0], [4.0, 1.0], [2.0, 4.0], [3.0, 0.0]];
            let known: Vec<(usize, Place)> = turned.into_iter().enumerate().collect();
            let layout = Layout::new(
                distance,
                Distances::of(distance, &clips()),
                procrustes(&map, &known),
            );
            for (clip, place) in clips().iter().zip(&layout.map().places) {
                assert!(is_near(layout.place(clip), *place));
            }
        }
    }

    #[test]
    fn what_lies_outside_the_plane_lies_at_its_foot() {
        let distance = Distance::default();
        let map = of_vectors(
            Distances::of(distance, &clips())
                .vectors()
                .expect("vectors"),
        );
        let layout = Layout::new(distance, Distances::of(distance, &clips()), map);
        let mut outside = clips()[2].recorded;
        outside[7] = 40.0;
        assert!(is_near(
            layout.place(&clip(outside)),
            layout.map().places[2]
        ));
    }

    #[test]
    fn a_mirror_image_comes_to_its_original_where_mirrors_are_known() {
        let settings = Settings {
            distance: distance(false, true),
            linkage: crate::settings::Linkage::Average,
            cut: None,
        };
        let compared = Comparison::of(clips(), settings).expect("settings that go together");
        let layout = Layout::new(settings.distance, compared.distances, compared.map);
        let mirrored = crate::distance::mirror(&clips()[3].recorded);
        assert!(is_near(
            layout.place(&clip(mirrored)),
            layout.place(&clips()[3])
        ));
        let plain = of_matrix(&crate::condensed::Condensed::from_fn(5, |one, other| {
            distance(false, false)
                .between(&clips()[one], &clips()[other])
                .value
        }));
        let distance = distance(false, false);
        let layout = Layout::new(distance, Distances::of(distance, &clips()), plain);
        assert!(!is_near(
            layout.place(&clip(mirrored)),
            layout.place(&clips()[3])
        ));
    }
}
