//! Skeletons under construction: joints go in one after the other, whole skeletons come out.

use nalgebra::Vector3;

use crate::bvh::notes::Notes;
use crate::bvh::place::Place;
use crate::note::NoteKind;
use crate::skeleton::{Channel, Joint, Skeleton};

/// Joints and End Sites of a usual skeleton.
const USUAL_JOINTS: usize = 64;

/// The skeletons of all ROOTs, the last of which is being built.
#[derive(Debug, Default)]
pub struct Skeletons {
    whole: Vec<Skeleton>,
    joints: Vec<Joint>,
    /// Where each joint of `joints` begins, and whether it has an OFFSET.
    begun: Vec<(Place, bool)>,
    joint_count: usize,
}

impl Skeletons {
    /// Skeletons begun so far.
    pub fn count(&self) -> usize {
        self.whole.len() + usize::from(!self.joints.is_empty())
    }

    /// Joints of all skeletons so far.
    pub fn joint_count(&self) -> usize {
        self.joint_count
    }

    /// Adds a joint and returns its index; the parent is one that was added.
    pub fn add(&mut self, name: String, parent: Option<usize>, is_end: bool, at: Place) -> usize {
        self.joint_count += 1;
        if self.joints.is_empty() {
            self.joints.reserve(USUAL_JOINTS);
            self.begun.reserve(USUAL_JOINTS);
        }
        self.begun.push((at, false));
        self.joints.push(Joint {
            name,
            parent,
            offset: Vector3::zeros(),
            channels: Vec::new(),
            first_channel: 0,
            is_end_site: is_end,
            line: at.line,
        });
        self.joints.len() - 1
    }

    /// Sets the OFFSET of a joint.
    pub fn set_offset(&mut self, joint: usize, offset: Vector3<f64>) {
        self.joints[joint].offset = offset;
        self.begun[joint].1 = true;
    }

    /// Adds a channel to a joint.
    pub fn add_channel(&mut self, joint: usize, channel: Channel) {
        self.joints[joint].channels.push(channel);
    }

    /// What messages call a joint.
    pub fn called(&self, joint: usize) -> String {
        let own = &self.joints[joint];
        match own.parent {
            Some(parent) if own.is_end_site => format!("{}/end", self.joints[parent].name),
            _ => own.name.clone(),
        }
    }

    /// Ends the skeleton being built: counts its columns and notes what its joints lack.
    pub fn end(&mut self, notes: &mut Notes) {
        if self.joints.is_empty() {
            return;
        }
        let mut is_parent = vec![false; self.joints.len()];
        let mut column = 0;
        for joint in &mut self.joints {
            joint.first_channel = column;
            column += joint.channels.len();
            if let Some(parent) = joint.parent {
                is_parent[parent] = true;
            }
        }
        for (joint, is_parent) in is_parent.into_iter().enumerate() {
            self.note_lacks(joint, is_parent, notes);
        }
        let joints = core::mem::take(&mut self.joints);
        self.begun.clear();
        self.whole.push(Skeleton { joints });
    }

    /// All skeletons, the last one having been ended.
    pub fn whole(self) -> Vec<Skeleton> {
        self.whole
    }

    fn note_lacks(&self, index: usize, is_parent: bool, notes: &mut Notes) {
        let joint = &self.joints[index];
        let (place, has_offset) = self.begun[index];
        if !has_offset {
            notes.add(NoteKind::MissingOffset, place, vec![self.called(index)]);
        }
        let channels = joint.channels.iter();
        let positions = channels
            .filter(|channel| matches!(channel, Channel::Position(_)))
            .count();
        if positions == 1 || positions == 2 {
            let details = vec![self.called(index), positions.to_string()];
            notes.add(NoteKind::PartialPosition, place, details);
        }
        if !is_parent && !joint.is_end_site {
            notes.add(NoteKind::MissingEndSite, place, vec![self.called(index)]);
        }
    }
}
