//! Leading rest pose: how many frames stand before the motion and are left out of the analysis.
//!
//! Many exporters put a T-pose before the motion, or blend one into it; the rule was measured on
//! 1 807 files.

use crate::body::Role;
use crate::note::{Note, NoteKind};
use crate::track::PelvisTrack;

/// Fewer frames than this are never cut.
const FEWEST_FRAMES: usize = 12;

/// At most this many frames are left out.
const MOST_LEFT_OUT: usize = 12;

/// The smallest T that is a T-pose: 1 is both arms straight out.
const T_POSE: f64 = 0.85;

/// A leading rest pose leaves by a step of at least so many median steps …
const STEP_RATIO: f64 = 3.0;

/// … and so many body heights away.
const DISTANCE: f64 = 0.06;

/// Steps after the rest pose whose median counts.
const STEPS_AFTER: usize = 24;

/// A jump after frame 0: at least so many body heights …
const JUMP: f64 = 0.1;

/// … and so many times the largest of the steps that follow.
const JUMP_RATIO: f64 = 4.0;

/// Steps that follow a jump.
const STEPS_AFTER_JUMP: usize = 10;

/// Leading frames that the rule needs to see of a motion.
pub const FRAMES_LOOKED_AT: usize = 48;

/// Why leading frames are left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RestReason {
    /// A T-pose.
    TPose,
    /// A T-pose that is blended into the motion.
    BlendedTPose,
    /// A jump after frame 0.
    Jump,
    /// A person said so.
    ByHand,
}

/// The frames left out before the motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LeadingRest {
    /// How many; the analysis starts at the frame of this number.
    pub frames: usize,
    /// Why; none where none are left out.
    pub reason: Option<RestReason>,
}

impl LeadingRest {
    /// Nothing is left out.
    pub const NONE: LeadingRest = LeadingRest {
        frames: 0,
        reason: None,
    };

    /// The note that says so.
    pub fn note(&self) -> Option<Note> {
        let kind = match self.reason? {
            RestReason::TPose => NoteKind::LeadingTPose,
            RestReason::BlendedTPose => NoteKind::LeadingBlendedTPose,
            RestReason::Jump => NoteKind::LeadingJump,
            RestReason::ByHand => NoteKind::LeadingByHand,
        };
        Some(Note::new(kind, vec![self.frames.to_string()]).at_frame(self.frames))
    }
}

/// The leading rest pose of a motion of `frames` frames.
///
/// `start` is its first [`FRAMES_LOOKED_AT`] frames (or more) in pelvis coordinates, unfiltered; `is_human` says
/// whether they are the 16 joints of a person. In any other body only a jump is found.
pub fn leading_rest_frames(start: &PelvisTrack, frames: usize, is_human: bool) -> LeadingRest {
    if frames < FEWEST_FRAMES || start.frames() < 2 {
        return LeadingRest::NONE;
    }
    let steps: Vec<f64> = (0..start.frames() - 1)
        .map(|n| step(start, n, n + 1))
        .collect();
    let pose = is_human.then(|| rest_pose(start, &steps, frames)).flatten();
    pose.or_else(|| jump(&steps)).unwrap_or(LeadingRest::NONE)
}

/// The root mean square of the joints' ways between two frames (x, y, z of joint after joint), in
/// body heights.
pub fn step_between(one: &[f64], other: &[f64]) -> f64 {
    let pairs = one.iter().zip(other);
    let sum: f64 = pairs
        .map(|(one, other)| (other - one) * (other - one))
        .sum();
    (sum / (one.len() / 3) as f64).sqrt()
}

/// The same between two frames of a track.
pub fn step(track: &PelvisTrack, one: usize, other: usize) -> f64 {
    step_between(track.frame(one), track.frame(other))
}

fn largest(steps: &[f64]) -> f64 {
    steps.iter().copied().fold(0.0, f64::max)
}

/// Steps 1 to 4: a T-pose that the motion leaves fast.
fn rest_pose(start: &PelvisTrack, steps: &[f64], frames: usize) -> Option<LeadingRest> {
    let window = MOST_LEFT_OUT.min((frames - 1) / 3).min(steps.len());
    let most = largest(&steps[..window]);
    let fast = |n: &usize| steps[*n] >= most / 2.0;
    let last = (0..window).rev().find(fast)?;
    if last == window - 1 {
        return None;
    }
    let is_blend = last >= 2 && (last - 2..=last).all(|n| fast(&n));
    let (count, reason) = match is_blend {
        true => (2 * (last + 1), RestReason::BlendedTPose),
        false => (last + 1, RestReason::TPose),
    };
    if count > MOST_LEFT_OUT || count >= start.frames() {
        return None;
    }
    let after = median(&steps[count.min(steps.len())..steps.len().min(count + STEPS_AFTER)]);
    let is_rest =
        t_pose(start) >= T_POSE && most >= STEP_RATIO * after && step(start, count, 0) >= DISTANCE;
    is_rest.then_some(LeadingRest {
        frames: count,
        reason: Some(reason),
    })
}

/// Step 5: frame 0 alone stands apart.
fn jump(steps: &[f64]) -> Option<LeadingRest> {
    let after = largest(&steps[1..steps.len().min(1 + STEPS_AFTER_JUMP)]);
    let is_jump = steps[0] >= JUMP && steps[0] >= JUMP_RATIO * after;
    is_jump.then_some(LeadingRest {
        frames: 1,
        reason: Some(RestReason::Jump),
    })
}

/// How far both arms are held out sideways in frame 0: 1 is straight out.
fn t_pose(start: &PelvisTrack) -> f64 {
    let pose = start.frame(0);
    let sideways = |shoulder: Role, wrist: Role| {
        let [x, y, z] = [0, 1, 2]
            .map(|axis| pose[3 * wrist.index() + axis] - pose[3 * shoulder.index() + axis]);
        let length = (x * x + y * y + z * z).sqrt();
        if length > 0.0 { x / length } else { 0.0 }
    };
    let left = sideways(Role::LeftShoulder, Role::LeftWrist);
    let right = sideways(Role::RightShoulder, Role::RightWrist);
    left.min(-right)
}

fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let middle = sorted.len() / 2;
    match sorted.len() % 2 {
        0 if sorted.is_empty() => 0.0,
        0 => (sorted[middle - 1] + sorted[middle]) / 2.0,
        _ => sorted[middle],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::PRINCIPAL_JOINTS;

    /// Frames with the wrists `sideways` (1: straight out), hanging where there are no more values; a toe
    /// walks on slowly.
    fn track(sideways: &[f64]) -> PelvisTrack {
        let mut coordinates = Vec::new();
        for frame in 0..100 {
            let mut pose = [[0.0_f64; 3]; PRINCIPAL_JOINTS];
            let out = sideways.get(frame).copied().unwrap_or(0.0);
            for (wrist, sign) in [(Role::LeftWrist, 1.0), (Role::RightWrist, -1.0)] {
                pose[wrist.index()] = [sign * out, out - 1.0, 0.0];
            }
            pose[Role::LeftToe.index()][2] = 0.001 * frame as f64;
            coordinates.extend(pose.iter().flatten());
        }
        PelvisTrack {
            coordinates,
            joint_count: PRINCIPAL_JOINTS,
            first_frame: 0,
        }
    }

    fn found(track: &PelvisTrack) -> (usize, Option<RestReason>) {
        let found = leading_rest_frames(track, track.frames(), true);
        (found.frames, found.reason)
    }

    #[test]
    fn a_t_pose_of_some_frames_is_left_out() {
        for rest in [1, 2, 5] {
            let track = track(&vec![1.0; rest]);
            assert_eq!(found(&track), (rest, Some(RestReason::TPose)));
        }
    }

    #[test]
    fn a_blended_t_pose_is_left_out_with_its_tail() {
        let track = track(&[1.0, 0.8, 0.6, 0.4, 0.2, 0.15, 0.1, 0.05]);
        assert_eq!(found(&track), (8, Some(RestReason::BlendedTPose)));
    }

    #[test]
    fn arms_that_are_lowered_slowly_are_movement() {
        let lowered: Vec<f64> = (0..30).map(|n| 1.0 - f64::from(n) / 30.0).collect();
        assert_eq!(found(&track(&lowered)), (0, None));
    }

    #[test]
    fn another_pose_alone_is_a_jump() {
        let mut track = track(&[]);
        track.coordinates[3 * Role::Head.index()] = 2.0;
        assert_eq!(found(&track), (1, Some(RestReason::Jump)));
        assert_eq!(leading_rest_frames(&track, 100, false).frames, 1);
        assert_eq!(leading_rest_frames(&track, 11, true), LeadingRest::NONE);
    }

    #[test]
    fn a_steady_motion_keeps_all_frames() {
        let track = track(&[1.0; 100]);
        assert_eq!(found(&track), (0, None));
        assert_eq!(leading_rest_frames(&track, 100, false), LeadingRest::NONE);
    }
}
