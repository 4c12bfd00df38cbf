//! Whether left and right are swapped: hips and trunk against the direction of toes and knees.

use nalgebra::Vector3;

use super::{Body, Role};
use crate::clip::Clip;
use crate::kinematics::Kinematics;
use crate::note::{Note, NoteKind};

/// The cosine below which toes point backwards.
const BACKWARDS: f64 = -0.5;

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

/// Whether the knees point backwards and the toes clearly so: within 60° of it.
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
    let ankles = at(Role::LeftAnkle)? + at(Role::RightAnkle)?;
    let toes = at(Role::LeftToe)? + at(Role::RightToe)? - ankles;
    let knees = at(Role::LeftKnee)? + at(Role::RightKnee)? - (left + right + ankles) / 2.0;
    let along = toes.dot(&forward);
    Some(
        along < 0.0
            && along <= BACKWARDS * toes.norm() * forward.norm()
            && knees.dot(&forward) < 0.0,
    )
}
