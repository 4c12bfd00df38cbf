//! In: a skeleton, the postures at even times and their rate. Out: the bytes of a BVH file.

use crate::euler;
use crate::posture::Posture;
use crate::rotation::Rotation;
use crate::skeleton::{Joint, Skeleton};
use nalgebra::Vector3;
use std::fmt::Write as _;

/// The whole file.
pub fn write(
    skeleton: &Skeleton,
    postures: impl ExactSizeIterator<Item = Posture>,
    rate_hz: f64,
) -> Vec<u8> {
    let mut text = String::from("HIERARCHY\n");
    write_joint(&mut text, skeleton, 0, 0);
    text += &format!(
        "MOTION\nFrames: {}\nFrame Time: {:.10}\n",
        postures.len(),
        1.0 / rate_hz
    );
    let mut angles = vec![[0.0; 3]; skeleton.joints.len()];
    for posture in postures {
        write_row(&mut text, skeleton, &posture, &mut angles);
    }
    text.into_bytes()
}

/// Writing to a `String` cannot fail.
macro_rules! put {
    ($text:expr, $($argument:tt)*) => {
        let _ = writeln!($text, $($argument)*);
    };
}

fn write_joint(text: &mut String, skeleton: &Skeleton, number: usize, depth: usize) {
    let joint = &skeleton.joints[number];
    let indent = "\t".repeat(depth);
    let kind = if joint.parent.is_some() {
        "JOINT"
    } else {
        "ROOT"
    };
    put!(text, "{indent}{kind} {}\n{indent}{{", joint.name);
    put!(
        text,
        "{indent}\tOFFSET {}",
        vector(&offset(skeleton, joint))
    );
    put!(text, "{indent}\tCHANNELS {}", channels(joint));
    for child in 0..skeleton.joints.len() {
        if skeleton.joints[child].parent == Some(number) {
            write_joint(text, skeleton, child, depth + 1);
        }
    }
    if let Some(tip) = &joint.tip {
        let offset = skeleton.offset(joint.segment, &joint.position, tip);
        put!(
            text,
            "{indent}\tEnd Site\n{indent}\t{{\n{indent}\t\tOFFSET {}",
            vector(&offset)
        );
        put!(text, "{indent}\t}}");
    }
    put!(text, "{indent}}}");
}

fn offset(skeleton: &Skeleton, joint: &Joint) -> Vector3<f64> {
    match joint.parent.map(|parent| &skeleton.joints[parent]) {
        Some(parent) => skeleton.offset(parent.segment, &parent.position, &joint.position),
        None => Vector3::zeros(),
    }
}

fn channels(joint: &Joint) -> String {
    let [a, b, c] = joint.order.map(|axis| format!("{}rotation", axis.letter()));
    match joint.parent {
        Some(_) => format!("3 {a} {b} {c}"),
        None => format!("6 Xposition Yposition Zposition {a} {b} {c}"),
    }
}

fn vector(v: &Vector3<f64>) -> String {
    format!("{:.6} {:.6} {:.6}", v.x + 0.0, v.y + 0.0, v.z + 0.0)
}

fn write_row(text: &mut String, skeleton: &Skeleton, posture: &Posture, angles: &mut [[f64; 3]]) {
    *text += &vector(&root_position(skeleton, posture));
    for (joint, angles) in skeleton.joints.iter().zip(angles) {
        *angles = euler::angles(
            &local_rotation(skeleton, posture, joint),
            joint.order,
            *angles,
        );
        let [a, b, c] = *angles;
        let _ = write!(text, " {a:.6} {b:.6} {c:.6}");
    }
    text.push('\n');
}

fn root_position(skeleton: &Skeleton, posture: &Posture) -> Vector3<f64> {
    let root = &skeleton.joints[0];
    let from_hips = root.position - Vector3::new(0.0, crate::body::HIP[1], 0.0);
    let position = posture.hip_middle + posture.world_from(root.segment) * from_hips;
    skeleton.file_from_body() * position * skeleton.body_height
}

/// `file_from_joint` is the turn from the rest pose, in the file's axes: C · G · Aᵀ · Cᵀ, with C the axes,
/// G the turn from the T pose and A that of the rest pose.
fn local_rotation(skeleton: &Skeleton, posture: &Posture, joint: &Joint) -> Rotation {
    let axes = skeleton.file_from_body();
    let world = |joint: &Joint| {
        let rest = skeleton.rest_from_t_pose(joint.segment);
        axes * posture.world_from(joint.segment) * rest.inverse() * axes.inverse()
    };
    match joint.parent.map(|parent| &skeleton.joints[parent]) {
        Some(parent) => world(parent).inverse() * world(joint),
        None => world(joint),
    }
}
