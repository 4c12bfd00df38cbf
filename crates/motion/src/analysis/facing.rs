//! Which way a performer faces: its poses go in, the yaw of a viewer in front of it comes out.

use nalgebra::Vector3;

use crate::body::PelvisFrame;
use crate::clip::Clip;
use crate::kinematics::{Kinematics, WorldFromJoint};
use crate::world::Up;

/// Frames, evenly spaced, that are looked at.
const SAMPLED_FRAMES: usize = 200;

/// The yaw (see [`Up::level_axes`]), in radians, of a viewer towards whom the pelvis frame's z axis,
/// forward, points in the mean over the motion. 0 without a level direction.
pub fn front_yaw_rad(clip: &Clip, performer: usize, frame: &PelvisFrame, up: Up) -> f64 {
    let kinematics = Kinematics::new(clip, performer);
    let mut pose = vec![WorldFromJoint::default(); kinematics.joint_count()];
    let forward = Vector3::from_iterator(frame.axes.row(2).iter().copied());
    let mut sum = Vector3::zeros();
    for n in (0..clip.frames).step_by(clip.frames / SAMPLED_FRAMES + 1) {
        kinematics.world_from_joint(n, &mut pose);
        sum += pose[frame.pelvis].rotation * forward;
    }
    let [first, second] = up.level_axes();
    let (sine, cosine) = (sum.dot(&first), -sum.dot(&second));
    match sine == 0.0 && cosine == 0.0 {
        true => 0.0,
        false => libm::atan2(sine, cosine),
    }
}
