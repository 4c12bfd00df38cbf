//! Motion capture in BVH: from the bytes of a file to its keyposes.
//!
//! One way through, each arrow one module, nothing pointing backwards:
//!
//! ```text
//! bytes ─▶ bvh ─▶ clip ─▶ kinematics ─▶ body ─▶ track (pelvis coordinates of the principal joints)
//!                                                 │
//!                        ┌────────────────────────┴──────────┐
//!                        ▼                                   ▼
//!      speed ▶ keypose (filter ▶ candidates ▶           feature (posture variation)
//!        correspondence ▶ intensity ▶ significance)
//!                        └─────────────────┬─────────────────┘
//!                                          ▼
//!                                 analysis ▶ report
//! ```
//!
//! The crate knows no browser, no file and no clock; every number is an `f64`, and the same
//! input gives the same bits on every platform.

pub mod analysis;
pub mod body;
pub mod bvh;
pub mod clip;
pub mod discontinuity;
pub mod feature;
pub mod figure;
pub mod hodrick_prescott;
pub mod keypose;
pub mod kinematics;
pub mod note;
pub mod part_change;
pub mod posture;
pub mod report;
pub mod rest;
pub mod skeleton;
pub mod speed;
pub mod track;
pub mod world;
