//! The joints of one performer in one flat list, each parent before its children.

use std::collections::BTreeMap;

use nalgebra::Vector3;

/// A coordinate axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// The first axis.
    X,
    /// The second axis.
    Y,
    /// The third axis.
    Z,
}

impl Axis {
    /// 0, 1 or 2.
    pub fn index(self) -> usize {
        self as usize
    }
}

/// What one value of a row does to its joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Channel {
    /// Replaces one component of the joint's offset, in file units.
    Position(Axis),
    /// Is added to one component of the joint's offset, in file units.
    AddedPosition(Axis),
    /// A rotation about one axis of the joint, in degrees.
    Rotation(Axis),
    /// Anything else (`Xscale` …): one value, skipped.
    Other,
}

/// One joint, or the End Site of one.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// The name as in the file; an End Site without a name of its own has an empty one.
    pub name: String,
    /// The index of the parent in [`Skeleton::joints`]; none at the root.
    pub parent: Option<usize>,
    /// The offset from the parent in its axes, in file units.
    pub offset: Vector3<f64>,
    /// The joint's channels in the order of the file.
    pub channels: Vec<Channel>,
    /// The first of the joint's channels, counted from the performer's first column.
    pub first_channel: usize,
    /// Whether this is an End Site.
    pub is_end_site: bool,
    /// The line of the file, from 1, on which the joint begins.
    pub line: usize,
}

impl Joint {
    /// Whether any channel moves the joint's position.
    pub fn has_position_channels(&self) -> bool {
        self.channels
            .iter()
            .any(|channel| matches!(channel, Channel::Position(_) | Channel::AddedPosition(_)))
    }
}

/// The joints of one performer; the root is joint 0, and every parent stands before its children.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Skeleton {
    /// Joints and End Sites in the order of the file.
    pub joints: Vec<Joint>,
}

impl Skeleton {
    /// Values that one frame of this performer takes.
    pub fn channel_count(&self) -> usize {
        self.joints.iter().map(|joint| joint.channels.len()).sum()
    }

    /// The children of every joint, in the order of the file.
    pub fn children(&self) -> Vec<Vec<usize>> {
        let mut children = vec![Vec::new(); self.joints.len()];
        for (index, joint) in self.joints.iter().enumerate() {
            if let Some(parent) = joint.parent {
                children[parent].push(index);
            }
        }
        children
    }

    /// A name for each joint that tells it apart from all others: the name in the file, or the
    /// path `a/b/c` from the root where the name is not unique; an End Site is its parent's
    /// label and `/end`. What would still be the same as a label before it gets `#2`, `#3` …
    pub fn labels(&self) -> Vec<String> {
        let mut labels: Vec<String> = Vec::with_capacity(self.joints.len());
        let mut distinct = Distinct::default();
        let is_unique = self.unique_names();
        for (joint, is_unique) in self.joints.iter().zip(&is_unique) {
            if *is_unique {
                distinct.reserve(&joint.name);
            }
        }
        for (index, joint) in self.joints.iter().enumerate() {
            labels.push(match joint.parent {
                _ if is_unique[index] => joint.name.clone(),
                Some(parent) if joint.is_end_site => {
                    distinct.label(&format!("{}/end", labels[parent]))
                }
                _ => distinct.label(&self.path(index)),
            });
        }
        labels
    }

    /// The names from the root to a joint; of a very long path its end.
    fn path(&self, joint: usize) -> String {
        const LONGEST: usize = 200;
        let mut path = self.joints[joint].name.clone();
        let mut next = self.joints[joint].parent;
        while let Some(parent) = next {
            if path.len() > LONGEST {
                return format!("…/{path}");
            }
            path = format!("{}/{path}", self.joints[parent].name);
            next = self.joints[parent].parent;
        }
        path
    }

    fn unique_names(&self) -> Vec<bool> {
        let mut counts = BTreeMap::new();
        for joint in self.joints.iter().filter(|joint| !joint.is_end_site) {
            *counts.entry(joint.name.as_str()).or_insert(0_usize) += 1;
        }
        self.joints
            .iter()
            .map(|joint| !joint.is_end_site && counts.get(joint.name.as_str()) == Some(&1))
            .collect()
    }
}

/// Labels given so far.
#[derive(Debug, Default)]
struct Distinct {
    /// Each label, and how often it was wanted.
    given: BTreeMap<String, usize>,
}

impl Distinct {
    /// Keeps a label from being given.
    fn reserve(&mut self, label: &str) {
        self.given.insert(label.to_owned(), 1);
    }

    /// `wanted`, or the first of `wanted#2`, `wanted#3` … that is not given.
    fn label(&mut self, wanted: &str) -> String {
        let mut number = self.given.get(wanted).copied().unwrap_or(0);
        let label = loop {
            number += 1;
            let label = match number {
                1 => wanted.to_owned(),
                _ => format!("{wanted}#{number}"),
            };
            if !self.given.contains_key(&label) {
                break label;
            }
        };
        self.given.insert(wanted.to_owned(), number);
        self.given.entry(label.clone()).or_insert(1);
        label
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn joint(name: &str, parent: Option<usize>, is_end_site: bool) -> Joint {
        Joint {
            name: name.to_owned(),
            parent,
            offset: Vector3::zeros(),
            channels: Vec::new(),
            first_channel: 0,
            is_end_site,
            line: 1,
        }
    }

    #[test]
    fn labels_are_paths_only_where_names_repeat() {
        let skeleton = Skeleton {
            joints: vec![
                joint("Hips", None, false),
                joint("Leg", Some(0), false),
                joint("", Some(1), true),
                joint("Leg", Some(0), false),
                joint("Head", Some(0), false),
                joint("", Some(4), true),
            ],
        };
        let expected = [
            "Hips",
            "Hips/Leg",
            "Hips/Leg/end",
            "Hips/Leg#2",
            "Head",
            "Head/end",
        ];
        assert_eq!(skeleton.labels(), expected);
    }

    #[test]
    fn labels_differ_whatever_the_names() {
        let skeleton = Skeleton {
            joints: vec![
                joint("a", None, false),
                joint("b", Some(0), false),
                joint("b", Some(0), false),
                joint("a/b", Some(0), false),
                joint("a/b#2", Some(0), false),
                joint("", Some(1), true),
                joint("tip", Some(1), true),
                joint("b", Some(1), false),
            ],
        };
        let expected = [
            "a",
            "a/b#3",
            "a/b#4",
            "a/b",
            "a/b#2",
            "a/b#3/end",
            "a/b#3/end#2",
            "a/b/b",
        ];
        assert_eq!(skeleton.labels(), expected);
    }

    #[test]
    fn a_deep_chain_of_long_equal_names_has_short_labels() {
        let name = "n".repeat(1000);
        let joints = (0..10_000_usize).map(|index| joint(&name, index.checked_sub(1), false));
        let skeleton = Skeleton {
            joints: joints.collect(),
        };
        let labels: std::collections::BTreeSet<_> = skeleton.labels().into_iter().collect();
        assert_eq!(labels.len(), 10_000);
        assert!(labels.iter().all(|label| label.len() < 2100));
    }
}
