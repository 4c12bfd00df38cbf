//! The skeleton as a tree: who stands above whom, and how far in the rest pose.

use nalgebra::Vector3;

use super::rest_pose::RestPose;
use crate::skeleton::Skeleton;

/// A skeleton with its children, depths and rest pose.
#[derive(Clone, Debug)]
pub struct Tree<'a> {
    /// The joints.
    pub skeleton: &'a Skeleton,
    /// The rest pose.
    pub rest: RestPose,
    children: Vec<Vec<usize>>,
    depth: Vec<usize>,
}

impl<'a> Tree<'a> {
    /// The tree of `skeleton` in `rest`.
    pub fn new(skeleton: &'a Skeleton, rest: RestPose) -> Self {
        let mut depth = vec![0; skeleton.joints.len()];
        for (index, joint) in skeleton.joints.iter().enumerate() {
            depth[index] = joint.parent.map_or(0, |parent| depth[parent] + 1);
        }
        Self {
            skeleton,
            rest,
            children: skeleton.children(),
            depth,
        }
    }

    /// Joints and End Sites.
    pub fn len(&self) -> usize {
        self.depth.len()
    }

    /// Steps from the root.
    pub fn depth(&self, joint: usize) -> usize {
        self.depth[joint]
    }

    /// Children and End Sites of a joint.
    pub fn children(&self, joint: usize) -> &[usize] {
        &self.children[joint]
    }

    /// The children of a joint that are no End Sites.
    pub fn joints_below(&self, joint: usize) -> impl Iterator<Item = usize> + '_ {
        let own = self.children[joint].iter().copied();
        own.filter(|child| !self.is_end_site(*child))
    }

    /// Whether it is an End Site.
    pub fn is_end_site(&self, joint: usize) -> bool {
        self.skeleton.joints[joint].is_end_site
    }

    /// The parent; none at the root.
    pub fn parent(&self, joint: usize) -> Option<usize> {
        self.skeleton.joints[joint].parent
    }

    /// The joint and all above it, upwards.
    pub fn upwards(&self, joint: usize) -> impl Iterator<Item = usize> + '_ {
        core::iter::successors(Some(joint), |joint| self.parent(*joint))
    }

    /// Whether `below` is `above` or stands below it.
    pub fn contains(&self, above: usize, below: usize) -> bool {
        let steps = match self.depth[below].checked_sub(self.depth[above]) {
            Some(steps) => steps,
            None => return false,
        };
        self.upwards(below).nth(steps) == Some(above)
    }

    /// The lowest joint that contains both.
    pub fn common(&self, one: usize, other: usize) -> usize {
        let found = self.upwards(one).find(|joint| self.contains(*joint, other));
        found.unwrap_or(0)
    }

    /// The joints from `above` (left out) down to `below`.
    pub fn path(&self, above: usize, below: usize) -> Vec<usize> {
        let mut path: Vec<usize> = self
            .upwards(below)
            .take_while(|joint| *joint != above)
            .collect();
        path.reverse();
        path
    }

    /// The length of a joint's offset in the rest pose.
    pub fn offset_length(&self, joint: usize) -> f64 {
        self.rest.offsets[joint].norm()
    }

    /// The sum of the offset lengths from `above` down to `below`.
    pub fn path_length(&self, above: usize, below: usize) -> f64 {
        let path = self.path(above, below);
        path.iter().map(|joint| self.offset_length(*joint)).sum()
    }

    /// The place of a joint in the rest pose, with the root in the origin.
    pub fn place(&self, joint: usize) -> Vector3<f64> {
        self.rest.places[joint]
    }

    /// The joint and everything below it, parents first.
    pub fn subtree(&self, joint: usize) -> Vec<usize> {
        let mut found = vec![joint];
        let mut next = 0;
        while next < found.len() {
            found.extend_from_slice(&self.children[found[next]]);
            next += 1;
        }
        found
    }
}
