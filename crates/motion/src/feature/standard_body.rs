//! A posture on a body of standard lengths: the 16 principal joints and the hips in pelvis
//! coordinates in, the joints of a standard body with the same bone directions out.
//!
//! The same motion on two rigs differs by bone lengths; on this body it does no more. Lengths are in
//! body heights, the origin is the middle of the hips.

use super::joint_variation::WIDTH;
use crate::body::{PRINCIPAL_JOINTS, Role};

/// A hand or a foot shorter than this (in body heights) has no direction of its own.
const NO_DIRECTION: f64 = 0.01;

const FORWARD: Point = [0.0, 0.0, 1.0];

/// The places of the hips, their middle and that of the shoulders, after the principal joints.
const LEFT_HIP: usize = PRINCIPAL_JOINTS;
const RIGHT_HIP: usize = PRINCIPAL_JOINTS + 1;
const HIPS: usize = PRINCIPAL_JOINTS + 2;
const SHOULDERS: usize = PRINCIPAL_JOINTS + 3;
const PLACES: usize = PRINCIPAL_JOINTS + 4;

const BONES: usize = 19;

type Point = [f64; 3];

/// The left and the right hip in pelvis coordinates.
pub type Hips = [Point; 2];

/// What a bone too short for a direction does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Short {
    /// It has its direction, unless it has no length at all.
    Itself,
    /// It goes on in the direction of the bone before.
    AsBefore,
    Forward,
}

/// A bone of the standard body, which ends at the place `to`.
#[derive(Clone, Copy, Debug)]
struct Bone {
    /// Its direction is that from here to `to`.
    from: usize,
    to: usize,
    /// Where it begins.
    start: usize,
    length: f64,
    short: Short,
}

const fn bone(from: usize, to: usize, length: f64) -> Bone {
    Bone {
        from,
        to,
        start: from,
        length,
        short: Short::Itself,
    }
}

/// Half of the line between two sides, from its middle.
const fn half(start: usize, from: usize, to: usize, length: f64) -> Bone {
    Bone {
        start,
        ..bone(from, to, length)
    }
}

/// A hand or a foot.
const fn end(from: usize, to: usize, length: f64, short: Short) -> Bone {
    Bone {
        short,
        ..bone(from, to, length)
    }
}

/// Every bone after the one at which it begins.
const STANDARD: [Bone; BONES] = {
    use Role as R;
    const fn at(role: Role) -> usize {
        role as usize
    }
    [
        half(HIPS, RIGHT_HIP, LEFT_HIP, 0.114 / 2.0),
        half(HIPS, LEFT_HIP, RIGHT_HIP, 0.114 / 2.0),
        bone(HIPS, SHOULDERS, 0.297),
        half(
            SHOULDERS,
            at(R::RightShoulder),
            at(R::LeftShoulder),
            0.211 / 2.0,
        ),
        half(
            SHOULDERS,
            at(R::LeftShoulder),
            at(R::RightShoulder),
            0.211 / 2.0,
        ),
        bone(at(R::LeftShoulder), at(R::LeftElbow), 0.169),
        bone(at(R::LeftElbow), at(R::LeftWrist), 0.151),
        end(at(R::LeftWrist), at(R::LeftFinger), 0.080, Short::AsBefore),
        bone(at(R::RightShoulder), at(R::RightElbow), 0.169),
        bone(at(R::RightElbow), at(R::RightWrist), 0.151),
        end(
            at(R::RightWrist),
            at(R::RightFinger),
            0.080,
            Short::AsBefore,
        ),
        bone(LEFT_HIP, at(R::LeftKnee), 0.263),
        bone(at(R::LeftKnee), at(R::LeftAnkle), 0.257),
        end(at(R::LeftAnkle), at(R::LeftToe), 0.110, Short::Forward),
        bone(RIGHT_HIP, at(R::RightKnee), 0.263),
        bone(at(R::RightKnee), at(R::RightAnkle), 0.257),
        end(at(R::RightAnkle), at(R::RightToe), 0.110, Short::Forward),
        bone(HIPS, at(R::Neck), 0.333),
        bone(at(R::Neck), at(R::Head), 0.118),
    ]
};

/// The posture of a body of standard lengths whose bones have the directions of `posture`. A hand
/// shorter than 0.01 body heights takes the forearm's direction, such a foot points forward; any other
/// bone without length stays without.
pub fn standard_posture(posture: &[f64; WIDTH], hips: &Hips) -> [f64; WIDTH] {
    let directions = directions(&places(posture, hips));
    let mut standard = [[0.0; 3]; PLACES];
    for (bone, direction) in STANDARD.iter().zip(directions) {
        let start = standard[bone.start];
        standard[bone.to] = [0, 1, 2].map(|axis| start[axis] + bone.length * direction[axis]);
    }
    core::array::from_fn(|index| standard[index / 3][index % 3])
}

fn places(posture: &[f64; WIDTH], hips: &Hips) -> [Point; PLACES] {
    let joint = |joint: usize| [0, 1, 2].map(|axis| posture[3 * joint + axis]);
    let middle = |one: Point, other: Point| [0, 1, 2].map(|axis| (one[axis] + other[axis]) / 2.0);
    core::array::from_fn(|place| match place {
        LEFT_HIP => hips[0],
        RIGHT_HIP => hips[1],
        HIPS => middle(hips[0], hips[1]),
        SHOULDERS => {
            let [left, right] = [Role::LeftShoulder, Role::RightShoulder].map(Role::index);
            middle(joint(left), joint(right))
        }
        _ => joint(place),
    })
}

/// The unit vectors along the bones. Roots and quotients of all bones stand in rows of their own, so that
/// several are made at once.
fn directions(places: &[Point; PLACES]) -> [Point; BONES] {
    let along = STANDARD.map(|bone| {
        let (from, to) = (places[bone.from], places[bone.to]);
        [to[0] - from[0], to[1] - from[1], to[2] - from[2]]
    });
    let squares = along.map(|[x, y, z]| x * x + y * y + z * z);
    let lengths = squares.map(f64::sqrt);
    let factors = lengths.map(|length| if length > 0.0 { 1.0 / length } else { 0.0 });
    let mut before = [0.0; 3];
    core::array::from_fn(|bone| {
        before = match STANDARD[bone].short {
            Short::AsBefore if lengths[bone] < NO_DIRECTION => before,
            Short::Forward if lengths[bone] < NO_DIRECTION => FORWARD,
            _ => along[bone].map(|value| value * factors[bone]),
        };
        before
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A T-pose with feet forward, made of other lengths, and the place of each joint on the
    /// standard body.
    const BODY: [(Point, Point); PRINCIPAL_JOINTS] = [
        ([0.2, 0.5, 0.0], [0.1055, 0.297, 0.0]),
        ([0.5, 0.5, 0.0], [0.2745, 0.297, 0.0]),
        ([0.5, 0.1, 0.0], [0.2745, 0.146, 0.0]),
        ([0.5, 0.1, 0.2], [0.2745, 0.146, 0.08]),
        ([0.2, -0.4, 0.0], [0.057, -0.263, 0.0]),
        ([0.2, -0.4, -0.3], [0.057, -0.263, -0.257]),
        ([0.2, -0.2, -0.3], [0.057, -0.153, -0.257]),
        ([-0.2, 0.5, 0.0], [-0.1055, 0.297, 0.0]),
        ([-0.3, 0.5, 0.0], [-0.2745, 0.297, 0.0]),
        ([-0.3, 0.5, 0.1], [-0.2745, 0.297, 0.151]),
        ([-0.3, 0.505, 0.1], [-0.2745, 0.297, 0.231]),
        ([-0.2, -0.4, 0.0], [-0.057, -0.263, 0.0]),
        ([-0.2, -0.9, 0.0], [-0.057, -0.52, 0.0]),
        ([-0.2, -0.9, 0.0], [-0.057, -0.52, 0.11]),
        ([0.0, 0.6, 0.0], [0.0, 0.333, 0.0]),
        ([0.0, 0.6, 0.3], [0.0, 0.333, 0.118]),
    ];

    fn posture(of: impl Fn(&(Point, Point)) -> Point) -> [f64; WIDTH] {
        core::array::from_fn(|index| of(&BODY[index / 3])[index % 3])
    }

    fn assert_near(found: &[f64; WIDTH], expected: &[f64; WIDTH]) {
        for (index, (found, expected)) in found.iter().zip(expected).enumerate() {
            assert!(
                (found - expected).abs() < 1e-14,
                "{index}: {found}, not {expected}"
            );
        }
    }

    #[test]
    fn directions_stay_and_lengths_are_standard() {
        let hips = [[0.2, 0.0, 0.0], [-0.2, 0.0, 0.0]];
        let found = standard_posture(&posture(|pair| pair.0), &hips);
        assert_near(&found, &posture(|pair| pair.1));
        let origin = [0.3, -0.2, 0.7];
        let moved = |point: Point| [0, 1, 2].map(|axis| point[axis] + origin[axis]);
        let found = standard_posture(&posture(|pair| moved(pair.0)), &hips.map(moved));
        assert_near(&found, &posture(|pair| pair.1));
    }

    #[test]
    fn a_standard_body_stays_as_it_is() {
        let hips = [[0.057, 0.0, 0.0], [-0.057, 0.0, 0.0]];
        let standard = posture(|pair| pair.1);
        assert_near(&standard_posture(&standard, &hips), &standard);
    }

    #[test]
    fn joints_in_one_point_have_no_direction() {
        let found = standard_posture(&[0.0; WIDTH], &[[0.0; 3]; 2]);
        let foot = 3 * Role::LeftToe.index();
        let mut expected = [0.0; WIDTH];
        expected[foot + 2] = 0.11;
        expected[3 * Role::RightToe.index() + 2] = 0.11;
        assert_eq!(found, expected);
    }
}
