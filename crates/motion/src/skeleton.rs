//! The joints of one performer in one flat list, each parent before its children.

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
    /// label and `/end`.
    pub fn labels(&self) -> Vec<String> {
        let mut labels: Vec<String> = Vec::with_capacity(self.joints.len());
        let mut paths: Vec<String> = Vec::with_capacity(self.joints.len());
        let unique = self.unique_names();
        for (index, joint) in self.joints.iter().enumerate() {
            let path = match joint.parent {
                Some(parent) => format!("{}/{}", paths[parent], joint.name),
                None => joint.name.clone(),
            };
            labels.push(match joint.parent {
                Some(parent) if joint.is_end_site => format!("{}/end", labels[parent]),
                _ if unique[index] => joint.name.clone(),
                _ => path.clone(),
            });
            paths.push(path);
        }
        labels
    }

    fn unique_names(&self) -> Vec<bool> {
        let mut counts = std::collections::BTreeMap::new();
        for joint in self.joints.iter().filter(|joint| !joint.is_end_site) {
            *counts.entry(joint.name.as_str()).or_insert(0_usize) += 1;
        }
        self.joints
            .iter()
            .map(|joint| !joint.is_end_site && counts.get(joint.name.as_str()) == Some(&1))
            .collect()
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
            "Hips/Leg",
            "Head",
            "Head/end",
        ];
        assert_eq!(skeleton.labels(), expected);
    }
}
