//! The planar map: features or a matrix of distances in, a place for every item out, near where the
//! distance is small.
//!
//! Classical scaling (Torgerson 1952, Gower 1966): the coordinates are the two leading eigenvectors of
//! `B = −½ J D² J`, J the centring matrix, times the root of their eigenvalue. Of vectors these are the
//! two principal axes. [`procrustes`] keeps a new map as the old one lay, [`gower_place`] puts a new
//! item into a map.

mod alignment;
mod matrix_scaling;
mod placement;
mod scaling;
mod spectrum;
mod tridiagonal;

use alignment::{middle, minus};

pub use alignment::procrustes;
pub use matrix_scaling::{MatrixMapSteps, of_matrix};
pub use placement::gower_place;
pub use scaling::of_vectors;

/// A place on the map; unit and scale are those of the distance.
pub type Place = [f64; 2];

/// Clips stay where they lie while that shows at least this part of what a map of their own would. Sets
/// in an order without a pattern stay above 0.75; a kind that comes after all of another falls to 0.2.
const LEAST_KEPT: f64 = 0.7;

/// Items in the plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    /// The place of each item. Their middle is the origin, the first axis has the larger spread, and
    /// each axis' largest coordinate by size is positive, until the map is laid onto another.
    pub places: Vec<Place>,
    /// The part of the spread that the plane shows, (λ1 + λ2) / Σ of the positive λ, from 0 to 1; 1
    /// where there is no spread.
    pub spread: f64,
    /// The squared distance of each item from the middle of all, in all dimensions.
    pub squares_from_middle: Vec<f64>,
}

impl Map {
    /// The same items at other places, one for each, with the part of the spread that is seen there.
    #[must_use]
    pub fn with_places(self, places: Vec<Place>) -> Self {
        Self {
            spread: self.spread_at(&places),
            places,
            ..self
        }
    }

    /// The same items at other places; none if so little of what the map shows is seen there that it
    /// is worth more than that they stay.
    #[must_use]
    pub fn kept_at(self, places: Vec<Place>) -> Option<Self> {
        let (own, kept) = (self.spread_at(&self.places), self.spread_at(&places));
        (kept >= LEAST_KEPT * own).then(|| self.with_places(places))
    }

    /// The part of the spread that is seen at such places of the items.
    fn spread_at(&self, places: &[Place]) -> f64 {
        let middle = middle(places);
        let square = |place: &Place| {
            let [x, y] = minus(*place, middle);
            x * x + y * y
        };
        let add = |sum: f64, square: f64| sum + square;
        let seen = places.iter().map(square).fold(0.0, add);
        let all = self.squares_from_middle.iter().copied().fold(0.0, add);
        match all > 0.0 {
            true => (seen / all).min(1.0),
            false => 1.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn at_its_own_places_a_map_has_its_own_spread() {
        let vector = |k: usize| {
            let mut vector = [0.0; 12];
            (vector[0], vector[4], vector[9]) =
                (k as f64, (k * k % 7) as f64, (k * 5 % 11) as f64 / 8.0);
            vector
        };
        let map = of_vectors(&(0..20).map(vector).collect::<Vec<_>>());
        let same = map.clone().with_places(map.places.clone());
        assert!(map.spread < 0.999 && (same.spread - map.spread).abs() < 1e-12);
        let on_a_line = map.places.iter().map(|[x, _]| [*x, 3.0]).collect();
        let line = map.clone().with_places(on_a_line);
        assert!(line.spread < map.spread - 0.01);
        assert!(map.clone().kept_at(map.places.clone()).is_some());
        let none = of_vectors(&[]).with_places(Vec::new());
        assert_eq!(none.spread.to_bits(), 1.0_f64.to_bits());
    }

    /// Items along one component, then others far along another: seen from the first plane the second
    /// kind lies in a heap.
    #[test]
    fn places_that_show_too_little_are_not_kept() {
        let vector = |k: usize, other_kind: f64| {
            let mut vector = [0.0; 12];
            (vector[0], vector[1], vector[2]) = ((k % 7) as f64, (k % 5) as f64, other_kind);
            vector
        };
        let first: Vec<_> = (0..35).map(|k| vector(k, 0.0)).collect();
        let before = of_vectors(&first);
        let lies = |k: usize| before.places[k % 35];
        let mut all = first.clone();
        all.extend((0..35).map(|k| vector(k, 1.0)));
        let near = of_vectors(&all);
        let places: Vec<Place> = (0..70).map(lies).collect();
        let kept = near.kept_at(places.clone()).expect("a kind that is near");
        assert_eq!(kept.places, places);
        for far in &mut all[35..] {
            far[2] = 30.0;
        }
        assert_eq!(of_vectors(&all).kept_at(places), None);
    }
}
