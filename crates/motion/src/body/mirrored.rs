//! Whether left and right are swapped: hips and trunk against the direction of toes and knees.

use nalgebra::Vector3;

use super::{Body, Role};
use crate::clip::Clip;
use crate::kinematics::Kinematics;
use crate::note::{Note, NoteKind};

/// `body` with a note if it is mirrored in most of every `step`-th frame.
pub fn noted(clip: &Clip, performer: usize, mut body: Body, step: usize) -> Body {
    let mut kinematics = Kinematics::new(clip, performer);
    let mut positions = vec![0.0; 3 * kinematics.joint_count()];
    let (mut looked_at, mut swapped) = (0, 0);
    for frame in (0..clip.frames).step_by(step) {
        if !body.is_human() {
            return body;
        }
        kinematics.positions(frame, &mut positions);
        looked_at += 1;
        swapped += usize::from(is_swapped(&body, &positions).unwrap_or(false));
    }
    if 2 * swapped > looked_at {
        body.notes.push(Note::new(NoteKind::Mirrored, Vec::new()));
    }
    body
}

/// Whether toes and knees both point backwards.
fn is_swapped(body: &Body, positions: &[f64]) -> Option<bool> {
    let at = |role: Role| -> Option<Vector3<f64>> {
        let joint = body.joint(role)?;
        Some(Vector3::from_column_slice(
            &positions[3 * joint..3 * joint + 3],
        ))
    };
    let (left, right) = (at(Role::LeftHip)?, at(Role::RightHip)?);
    let up = at(Role::Neck)? - (left + right) / 2.0;
    let forward = (left - right).cross(&up);
    let toes =
        at(Role::LeftToe)? - at(Role::LeftAnkle)? + at(Role::RightToe)? - at(Role::RightAnkle)?;
    let knees = at(Role::LeftKnee)? - (left + at(Role::LeftAnkle)?) / 2.0 + at(Role::RightKnee)?
        - (right + at(Role::RightAnkle)?) / 2.0;
    Some(toes.dot(&forward) < 0.0 && knees.dot(&forward) < 0.0)
}
