//! Poses for drawing: frames of a clip go in, positions in single precision come out. This is the
//! one place where numbers leave double precision.

use motion::clip::Clip;
use motion::kinematics::{Kinematics, WorldFromJoint};

/// Where joints stand at the frames given: frames × joints × (x, y, z), in file units. Frame 0 of
/// a clip without frames is the pose of the OFFSETs alone.
///
/// # Errors
/// A sentence, where a frame is not in the clip.
pub fn poses(
    clip: &Clip,
    performer: usize,
    frames: impl ExactSizeIterator<Item = i64>,
) -> Result<Vec<f32>, String> {
    if performer >= clip.performers.len() {
        let count = clip.performers.len();
        return Err(format!(
            "performer {performer} asked for, the clip has {count}"
        ));
    }
    let mut kinematics = Kinematics::new(clip, performer);
    let mut pose = vec![0.0; 3 * kinematics.joint_count()];
    let mut positions = Vec::with_capacity(frames.len() * pose.len());
    for frame in frames {
        let inside = usize::try_from(frame)
            .ok()
            .filter(|frame| *frame < clip.frames);
        match inside {
            Some(inside) => kinematics.positions(inside, &mut pose),
            None if clip.frames == 0 && frame == 0 => rest(&kinematics, &mut pose),
            None => {
                return Err(format!(
                    "frame {frame} asked for, the clip has {}",
                    clip.frames
                ));
            }
        }
        positions.extend(pose.iter().map(|value| *value as f32));
    }
    Ok(positions)
}

fn rest(kinematics: &Kinematics, positions: &mut [f64]) {
    let mut pose = vec![WorldFromJoint::default(); kinematics.joint_count()];
    kinematics.rest(&mut pose);
    for (place, joint) in positions.chunks_exact_mut(3).zip(&pose) {
        place.copy_from_slice(joint.position.as_slice());
    }
}
