//! Comparing motions: the features of a set of clips in; distances, a tree, its cuts, a map, scores
//! against labels and reasons out.
//!
//! One way through, nothing pointing backwards:
//!
//! ```text
//! features ─▶ distance ─▶ condensed matrix ─▶ linkage ─▶ dendrogram ─▶ leaf order, cut
//!                │               ├─▶ map
//!                ▼               └─▶ neighbours ─▶ evaluation (with labels)
//!           explanation                postures of two clips ─▶ warping
//! ```
//!
//! The crate knows no clip, no file and no clock; every number is an `f64`, and the same input gives
//! the same bits on every platform.

mod blocks;
pub mod comparison;
pub mod condensed;
pub mod cut;
pub mod dendrogram;
pub mod distance;
pub mod distances;
pub mod evaluation;
pub mod explanation;
pub mod feature;
pub mod layout;
pub mod leaf_order;
pub mod linkage;
pub mod map;
pub mod neighbours;
pub mod picture;
pub mod ranks;
pub mod report;
pub mod run;
pub mod settings;
pub mod spread;
pub mod warping;
