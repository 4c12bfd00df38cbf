//! The rig of Poser and DAZ: buttocks and collars, a few fingers, an order of rotation for each kind of limb.

use crate::body::{
    ANKLE, BALL, CLAVICLE, ELBOW, FINGER_TIP, HEAD, HEAD_TOP, HIP, KNEE, KNUCKLE, LUMBAR, Limb,
    NECK, PELVIS, SHOULDER, Segment, Side, THORAX, TOE_TIP, WRIST,
};
use crate::euler::Axis::{X, Y, Z};
use crate::skeleton::{Skeleton, middle, on};
use nalgebra::Vector3;

const TRUNK: [crate::euler::Axis; 3] = [X, Z, Y];
const ARM: [crate::euler::Axis; 3] = [X, Y, Z];
const LEG: [crate::euler::Axis; 3] = [X, Z, Y];
const FOOT: [crate::euler::Axis; 3] = [Y, Z, X];

const BUTTOCK: [f64; 3] = [0.030, 0.576, -0.002];

pub fn skeleton() -> Skeleton {
    let mut s = Skeleton {
        joints: Vec::new(),
        body_height: 66.0,
        z_up: false,
        arms_down_deg: 80.0,
    };
    let hip = s.add(None, "hip", middle(PELVIS), Segment::Pelvis, [Y, X, Z]);
    let abdomen = s.add(
        Some(hip),
        "abdomen",
        middle(LUMBAR),
        Segment::Midriff,
        TRUNK,
    );
    let chest = s.add(
        Some(abdomen),
        "chest",
        middle(THORAX),
        Segment::Thorax,
        TRUNK,
    );
    let neck = s.add(Some(chest), "neck", middle(NECK), Segment::Neck, TRUNK);
    s.add_leaf(
        Some(neck),
        "head",
        [middle(HEAD), middle(HEAD_TOP)],
        Segment::Head,
        TRUNK,
    );
    for side in Side::BOTH {
        arm(&mut s, chest, side);
    }
    for side in Side::BOTH {
        leg(&mut s, hip, side);
    }
    s
}

fn named(side: Side, part: &str) -> String {
    format!("{}{part}", if side == Side::Left { "l" } else { "r" })
}

fn arm(s: &mut Skeleton, chest: usize, side: Side) {
    let name = |part: &str| named(side, part);
    let part = |limb| Segment::Limb(side, limb);
    let at = |point| on(side, point);
    let collar = s.add(
        Some(chest),
        name("Collar"),
        at(CLAVICLE),
        part(Limb::Clavicle),
        ARM,
    );
    let upper = s.add(
        Some(collar),
        name("Shldr"),
        at(SHOULDER),
        part(Limb::UpperArm),
        ARM,
    );
    let fore = s.add(
        Some(upper),
        name("ForeArm"),
        at(ELBOW),
        part(Limb::Forearm),
        ARM,
    );
    let hand = s.add(Some(fore), name("Hand"), at(WRIST), part(Limb::Hand), ARM);
    let thumb = [at(WRIST) + Vector3::new(side.sign() * 0.014, -0.004, 0.014); 2];
    let thumb = [
        thumb[0],
        thumb[0] + Vector3::new(side.sign() * 0.026, -0.004, 0.022),
    ];
    s.add_leaf(Some(hand), name("Thumb1"), thumb, part(Limb::Hand), ARM);
    let mid = s.add(
        Some(hand),
        name("Mid1"),
        at(KNUCKLE),
        part(Limb::Fingers),
        ARM,
    );
    let tip = at(FINGER_TIP);
    let second = at(KNUCKLE) + (tip - at(KNUCKLE)) * 0.55;
    s.add_leaf(
        Some(mid),
        name("Mid2"),
        [second, tip],
        part(Limb::Fingers),
        ARM,
    );
}

fn leg(s: &mut Skeleton, hip: usize, side: Side) {
    let name = |part: &str| named(side, part);
    let part = |limb| Segment::Limb(side, limb);
    let at = |point| on(side, point);
    let buttock = s.add(
        Some(hip),
        name("Buttock"),
        at(BUTTOCK),
        Segment::Pelvis,
        LEG,
    );
    let thigh = s.add(
        Some(buttock),
        name("Thigh"),
        at(HIP),
        part(Limb::Thigh),
        LEG,
    );
    let shin = s.add(Some(thigh), name("Shin"), at(KNEE), part(Limb::Shin), LEG);
    let foot = s.add(Some(shin), name("Foot"), at(ANKLE), part(Limb::Foot), FOOT);
    s.add_leaf(
        Some(foot),
        name("Toe"),
        [at(BALL), at(TOE_TIP)],
        part(Limb::Toes),
        FOOT,
    );
}
