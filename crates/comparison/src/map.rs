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
        let middle = middle(&places);
        let square = |place: &Place| {
            let [x, y] = minus(*place, middle);
            x * x + y * y
        };
        let add = |sum: f64, square: f64| sum + square;
        let seen = places.iter().map(square).fold(0.0, add);
        let all = self.squares_from_middle.iter().copied().fold(0.0, add);
        Self {
            places,
            spread: if all > 0.0 {
                (seen / all).min(1.0)
            } else {
                1.0
            },
            ..self
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
        let none = of_vectors(&[]).with_places(Vec::new());
        assert_eq!(none.spread.to_bits(), 1.0_f64.to_bits());
    }
}
