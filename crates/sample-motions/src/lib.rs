//! Synthetic dances and gaits as BVH, each with its true keyposes.
//!
//! The recipe: joint angles set by hand at poses, quintic moves between them, the foot on the ground
//! locked by inverse kinematics, the height of the pelvis from the leg that carries, arms opposite to the legs, and a
//! lag of 40 to 80 ms down each chain. Everything is computed once in body heights and then written in
//! the names, axes, unit, rest pose and channel orders of a rig.
//!
//! The bytes are the same on every platform: sine and its like come from `libm`, sums have one order.

mod arm;
mod body;
mod bvh_text;
mod catalogue;
mod dance;
mod dance_move;
mod dance_pose;
mod dance_steps;
mod dance_tired;
mod euler;
mod gait_foot;
mod leg_ik;
mod posture;
mod quintic;
mod rig;
mod rig_hik;
mod rig_poser;
mod rig_vrm;
mod rotation;
mod run;
mod run_swing;
mod sample;
mod skeleton;
mod take;
mod variation;
mod walk;

pub use catalogue::{Entry, catalogue};
pub use rig::Rig;
pub use sample::{Mark, Motion, Rate, Sample, bvh, true_keyposes};
pub use variation::Variation;
