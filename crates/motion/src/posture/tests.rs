//! The words of poses that are put together by hand: +y up, +x to the left, +z forward, in body
//! heights.

use nalgebra::Vector3;

use super::{Pose, posture};
use crate::body::{Role, Side};

type Point = [f64; 3];

const ARM: f64 = 0.16;
const LEG: f64 = 0.26;

/// A person who stands at the origin; limbs are then bent with [`Person::limb`].
struct Person(Pose);

impl Person {
    fn standing() -> Self {
        let mut person = Self(Pose {
            places: vec![Vector3::zeros(); Role::ALL.len()],
            up: Vector3::y(),
            ground: 0.0,
            pelvis_left: Vector3::x(),
        });
        person.put(Role::Pelvis, [0.0, 0.57, 0.0]);
        person.put(Role::Neck, [0.0, 0.9, 0.0]);
        person.put(Role::Head, [0.0, 1.05, 0.0]);
        for (side, x) in [(Side::Left, 1.0), (Side::Right, -1.0)] {
            let [shoulder, ..] = Role::arm(side);
            let [hip, ..] = Role::leg(side);
            person.put(shoulder, [0.1 * x, 0.87, 0.0]);
            person.put(hip, [0.057 * x, 0.57, 0.0]);
            person.limb(Role::arm(side), ARM, [[0.0, -1.0, 0.0]; 2]);
            person.limb(Role::leg(side), LEG, [[0.0, -1.0, 0.0]; 2]);
        }
        person
    }

    fn put(&mut self, role: Role, place: Point) {
        self.0.places[role.index()] = Vector3::from(place);
    }

    /// Lays the two bones of a limb along directions, from its first joint.
    fn limb(&mut self, roles: [Role; 4], bone: f64, along: [Point; 2]) {
        let mut place = self.0.at(roles[0]);
        for (role, along) in roles[1..].iter().zip(along) {
            place += Vector3::from(along).normalize() * bone;
            self.0.places[role.index()] = place;
        }
        self.0.places[roles[3].index()] = place;
    }

    fn arm(mut self, side: Side, along: [Point; 2]) -> Self {
        self.limb(Role::arm(side), ARM, along);
        self
    }

    fn leg(mut self, side: Side, along: [Point; 2]) -> Self {
        self.limb(Role::leg(side), LEG, along);
        self
    }

    /// Turns neck, head and arms about the middle of the hips, from up towards `towards`.
    fn lean(mut self, towards: Point, degrees: f64) -> Self {
        let (sine, cosine) = libm::sincos(degrees.to_radians());
        let (up, towards) = (Vector3::y(), Vector3::from(towards));
        let hips = Vector3::new(0.0, 0.57, 0.0);
        let mut roles = vec![Role::Neck, Role::Head];
        roles.extend(Side::BOTH.into_iter().flat_map(Role::arm));
        for role in roles {
            let from = self.0.at(role) - hips;
            let (height, ahead) = (from.dot(&up), from.dot(&towards));
            let turned =
                up * (height * cosine - ahead * sine) + towards * (height * sine + ahead * cosine);
            self.0.places[role.index()] = hips + from - up * height - towards * ahead + turned;
        }
        self
    }

    /// Moves everything along `up`.
    fn higher(mut self, by: f64) -> Self {
        self.0.places.iter_mut().for_each(|place| place.y += by);
        self
    }

    fn words(&self) -> Vec<String> {
        posture(&self.0).iter().map(|word| word.name()).collect()
    }
}

const UP: Point = [0.0, 1.0, 0.0];
const DOWN: Point = [0.0, -1.0, 0.0];
const LEFT: Point = [1.0, 0.0, 0.0];
const RIGHT: Point = [-1.0, 0.0, 0.0];
const AHEAD: Point = [0.0, 0.0, 1.0];
const BEHIND: Point = [0.0, 0.0, -1.0];

#[test]
fn one_who_stands_is_upright() {
    assert_eq!(Person::standing().words(), ["trunk-upright"]);
}

#[test]
fn arms() {
    use Side::{Left, Right};
    let standing = Person::standing;
    let cases = [
        (standing().arm(Left, [UP; 2]), "left-arm-raised"),
        (
            standing().arm(Left, [UP; 2]).arm(Right, [UP; 2]),
            "both-arms-raised",
        ),
        (standing().arm(Right, [RIGHT; 2]), "right-arm-stretched"),
        (standing().arm(Right, [AHEAD; 2]), "right-arm-stretched"),
        (
            standing().arm(Left, [LEFT; 2]).arm(Right, [RIGHT; 2]),
            "both-arms-stretched",
        ),
        (
            standing().arm(Left, [[0.0, -0.3, 1.0], [0.0, -0.2, 1.0]]),
            "left-arm-stretched",
        ),
        (
            standing().arm(Left, [[0.0, -1.0, 0.9], [0.0, -0.5, 1.0]]),
            "left-arm-forward",
        ),
        (
            standing().arm(Left, [[0.0, -1.0, -1.0], [0.0, -1.0, -1.0]]),
            "left-arm-back",
        ),
        (
            standing().arm(Right, [[0.0, -1.0, 0.3], [1.0, 0.2, 0.6]]),
            "right-arm-crossed",
        ),
        (
            standing().arm(Left, [[0.5, -1.0, 0.0], [0.1, 1.0, 0.3]]),
            "left-arm-bent",
        ),
    ];
    for (person, expected) in cases {
        assert_eq!(person.words(), [expected]);
    }
}

#[test]
fn legs() {
    use Side::{Left, Right};
    let standing = Person::standing;
    let cases = [
        (standing().leg(Left, [AHEAD; 2]), "left-leg-high"),
        (standing().leg(Right, [BEHIND; 2]), "right-leg-high"),
        (standing().leg(Right, [AHEAD, DOWN]), "right-leg-raised"),
        (standing().leg(Right, [DOWN, BEHIND]), "right-leg-lifted"),
        (
            standing()
                .leg(Left, [[0.0, -1.0, 0.5]; 2])
                .leg(Right, [[0.0, -1.0, -0.5]; 2]),
            "left-leg-forward",
        ),
        (
            standing()
                .leg(Left, [[0.6, -1.0, 0.0]; 2])
                .leg(Right, [[-0.6, -1.0, 0.0]; 2]),
            "both-legs-apart",
        ),
        (
            standing()
                .leg(Left, [[-0.3, -1.0, 0.1]; 2])
                .leg(Right, [[0.3, -1.0, 0.0]; 2]),
            "both-legs-crossed",
        ),
        (
            standing()
                .leg(Left, [[0.0, -0.3, 1.0], [0.0, -0.8, -1.0]])
                .leg(Right, [[0.0, -0.3, 1.0], [0.0, -0.8, -1.0]])
                .higher(-0.24),
            "both-legs-bent",
        ),
        (standing().higher(0.3), "both-legs-lifted"),
        (
            standing()
                .leg(Left, [[1.0, -0.7, 0.0]; 2])
                .leg(Right, [[-1.0, -0.7, 0.0]; 2]),
            "both-legs-high",
        ),
    ];
    for (person, expected) in cases {
        assert_eq!(person.words(), [expected]);
    }
}

#[test]
fn trunk() {
    let lean = |towards, degrees| Person::standing().lean(towards, degrees).words()[0].clone();
    assert_eq!(lean(AHEAD, 40.0), "trunk-leaning-forward");
    assert_eq!(lean(BEHIND, 35.0), "trunk-leaning-back");
    assert_eq!(lean(LEFT, 35.0), "trunk-leaning-left");
    assert_eq!(lean(RIGHT, 35.0), "trunk-leaning-right");
    let lying = Person::standing().lean(AHEAD, 90.0).higher(-0.45);
    assert_eq!(lying.words()[0], "trunk-lying");
}

#[test]
fn at_most_two_words_the_farthest_first() {
    let person = Person::standing()
        .arm(Side::Left, [UP; 2])
        .arm(Side::Right, [[-1.0, -0.3, 0.0]; 2])
        .leg(Side::Left, [[0.0, -1.0, 0.4]; 2])
        .leg(Side::Right, [[0.0, -1.0, -0.4]; 2]);
    let words = person.words();
    assert_eq!(words.len(), 2);
    assert_eq!(words[0], "left-arm-raised");
}

#[test]
fn the_world_may_lie_otherwise() {
    // The same person with +z up and facing −x.
    let turned = |point: Vector3<f64>| Vector3::new(-point.z, -point.x, point.y);
    let mut person = Person::standing()
        .leg(Side::Right, [AHEAD, DOWN])
        .lean(LEFT, 40.0);
    let expected = person.words();
    person
        .0
        .places
        .iter_mut()
        .for_each(|place| *place = turned(*place));
    person.0.up = turned(person.0.up);
    person.0.pelvis_left = turned(person.0.pelvis_left);
    assert_eq!(person.words(), expected);
}
