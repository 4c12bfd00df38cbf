//! The rest pose: the OFFSETs, and the mean of the position channels where an OFFSET is zero.

use nalgebra::Vector3;

use crate::clip::Clip;
use crate::skeleton::{Channel, Joint};

/// An OFFSET below this share of the skeleton's size is zero.
pub const ZERO_OFFSET: f64 = 1e-4;

/// Where the joints stand without any rotation.
#[derive(Clone, Debug, PartialEq)]
pub struct RestPose {
    /// The offset of each joint from its parent, in file units; that of the root is zero.
    pub offsets: Vec<Vector3<f64>>,
    /// The place of each joint from the root, in file units.
    pub places: Vec<Vector3<f64>>,
    /// The longest way from the root to a joint along the offsets, End Sites not counted, in file
    /// units: 0.8 to 0.9 body heights in a human.
    pub size: f64,
}

impl RestPose {
    /// The rest pose of one performer; means are taken over every `step`-th frame from
    /// `first_frame` on.
    pub fn new(clip: &Clip, performer: usize, first_frame: usize, step: usize) -> Self {
        let joints = &clip.performers[performer].skeleton.joints;
        let mut offsets: Vec<_> = joints.iter().map(|joint| joint.offset).collect();
        if let Some(root) = offsets.first_mut() {
            *root = Vector3::zeros();
        }
        let zero = ZERO_OFFSET * size(joints, &offsets);
        for (index, joint) in joints.iter().enumerate().skip(1) {
            if offsets[index].norm() <= zero && joint.has_position_channels() {
                offsets[index] = mean_position(clip, performer, joint, first_frame, step);
            }
        }
        let size = size(joints, &offsets);
        let places = places(joints, &offsets);
        Self {
            offsets,
            places,
            size,
        }
    }

    /// Whether the offset of a joint is none.
    pub fn is_zero(&self, joint: usize) -> bool {
        self.offsets[joint].norm() <= ZERO_OFFSET * self.size
    }
}

fn size(joints: &[Joint], offsets: &[Vector3<f64>]) -> f64 {
    let mut ways = vec![0.0_f64; joints.len()];
    let mut longest = 0.0_f64;
    for (index, joint) in joints.iter().enumerate() {
        let above = joint.parent.map_or(0.0, |parent| ways[parent]);
        ways[index] = above + offsets[index].norm();
        if !joint.is_end_site {
            longest = longest.max(ways[index]);
        }
    }
    longest
}

fn places(joints: &[Joint], offsets: &[Vector3<f64>]) -> Vec<Vector3<f64>> {
    let mut places: Vec<Vector3<f64>> = Vec::with_capacity(joints.len());
    for (joint, offset) in joints.iter().zip(offsets) {
        let above = joint
            .parent
            .map_or_else(Vector3::zeros, |parent| places[parent]);
        places.push(above + offset);
    }
    places
}

fn mean_position(
    clip: &Clip,
    performer: usize,
    joint: &Joint,
    first_frame: usize,
    step: usize,
) -> Vector3<f64> {
    let mut sum = Vector3::zeros();
    let mut count = 0.0;
    for frame in (first_frame..clip.frames).step_by(step.max(1)) {
        let values = &clip.frame_values(performer, frame)[joint.first_channel..];
        sum += position(joint, values);
        count += 1.0;
    }
    if count > 0.0 {
        sum / count
    } else {
        joint.offset
    }
}

/// The offset that one frame's values give a joint.
fn position(joint: &Joint, values: &[f64]) -> Vector3<f64> {
    let mut offset = joint.offset;
    for (channel, value) in joint.channels.iter().zip(values) {
        match *channel {
            Channel::Position(axis) => offset[axis.index()] = *value,
            Channel::AddedPosition(axis) => offset[axis.index()] += *value,
            _ => {}
        }
    }
    offset
}
