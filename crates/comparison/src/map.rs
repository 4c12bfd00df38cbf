//! The planar map: features or a matrix of distances in, a place for every item out, near where the
//! distance is small.
//!
//! Classical scaling (Torgerson 1952, Gower 1966): the coordinates are the two leading eigenvectors of
//! `B = −½ J D² J`, J the centring matrix, times the root of their eigenvalue. Of vectors these are the
//! two principal axes. [`procrustes`] keeps a new map as the old one lay, [`gower_place`] puts a new
//! item into a map.

mod alignment;
mod placement;
mod scaling;
mod spectrum;
mod tridiagonal;

pub use alignment::procrustes;
pub use placement::gower_place;
pub use scaling::{of_matrix, of_vectors};

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
