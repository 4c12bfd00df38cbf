//! The skeleton of a rig: the joints of a file, which segment each follows, and the file's axes, unit
//! and rest pose.

use crate::body::{Limb, Segment, Side};
use crate::euler::Axis;
use crate::rotation::{Rotation, about_x, about_z};
use nalgebra::Vector3;

/// A joint; positions are those of the body in the T pose, in body heights.
pub struct Joint {
    pub name: String,
    pub parent: Option<usize>,
    pub position: Vector3<f64>,
    pub segment: Segment,
    pub order: [Axis; 3],
    /// The End Site of a leaf.
    pub tip: Option<Vector3<f64>>,
}

/// The joints, parents first and depth first, and how the body becomes numbers of the file.
pub struct Skeleton {
    pub joints: Vec<Joint>,
    /// File units in a body height.
    pub body_height: f64,
    pub z_up: bool,
    /// How far the arms hang at rest, in degrees below the T pose.
    pub arms_down_deg: f64,
}

impl Skeleton {
    /// Adds a joint and gives its number.
    pub fn add(
        &mut self,
        parent: Option<usize>,
        name: impl Into<String>,
        position: Vector3<f64>,
        segment: Segment,
        order: [Axis; 3],
    ) -> usize {
        let name = name.into();
        self.joints.push(Joint {
            name,
            parent,
            position,
            segment,
            order,
            tip: None,
        });
        self.joints.len() - 1
    }

    /// Adds a leaf with its End Site.
    pub fn add_leaf(
        &mut self,
        parent: Option<usize>,
        name: impl Into<String>,
        [position, tip]: [Vector3<f64>; 2],
        segment: Segment,
        order: [Axis; 3],
    ) -> usize {
        let joint = self.add(parent, name, position, segment, order);
        self.joints[joint].tip = Some(tip);
        joint
    }

    /// The axes of the file from those of the body.
    pub fn file_from_body(&self) -> Rotation {
        if self.z_up {
            about_x(std::f64::consts::FRAC_PI_2)
        } else {
            Rotation::identity()
        }
    }

    /// The turn of a segment from the T pose to the rig's rest pose, in the axes of the body.
    pub fn rest_from_t_pose(&self, segment: Segment) -> Rotation {
        match segment {
            Segment::Limb(side, Limb::UpperArm | Limb::Forearm | Limb::Hand | Limb::Fingers) => {
                about_z(-side.sign() * self.arms_down_deg.to_radians())
            }
            _ => Rotation::identity(),
        }
    }

    /// A vector of the body at rest, seen by a segment, in the file's axes and unit.
    pub fn offset(&self, segment: Segment, from: &Vector3<f64>, to: &Vector3<f64>) -> Vector3<f64> {
        let rest = self.rest_from_t_pose(segment) * (to - from);
        self.file_from_body() * rest * self.body_height
    }
}

/// A point given for the left side, on a side.
pub fn on(side: Side, point: [f64; 3]) -> Vector3<f64> {
    side.mirror(point)
}

/// A point in the middle of the body.
pub fn middle(point: [f64; 3]) -> Vector3<f64> {
    Vector3::from(point)
}
