//! The rig of VRoid: an upper chest, five fingers of three joints, a twist helper in the forearm.

use crate::body::{
    ANKLE, BALL, CLAVICLE, ELBOW, HEAD, HEAD_TOP, HIP, KNEE, LUMBAR, Limb, MIDRIFF, NECK, PELVIS,
    SHOULDER, Segment, Side, THORAX, TOE_TIP, WRIST,
};
use crate::euler::Axis;
use crate::skeleton::{Skeleton, middle, on};
use nalgebra::Vector3;

const ORDER: [Axis; 3] = [Axis::Z, Axis::Y, Axis::X];

/// Name, first knuckle from the wrist and the whole finger's length and direction: (out, up, forward).
const FINGERS: [(&str, [f64; 3], [f64; 3]); 5] = [
    ("Thumb", [0.012, -0.005, 0.014], [0.024, -0.006, 0.024]),
    ("Index", [0.049, 0.0, 0.012], [0.037, -0.003, 0.002]),
    ("Middle", [0.049, 0.0, 0.002], [0.041, -0.003, 0.0]),
    ("Ring", [0.047, 0.0, -0.007], [0.038, -0.003, -0.001]),
    ("Little", [0.043, 0.0, -0.015], [0.030, -0.003, -0.003]),
];

pub fn skeleton() -> Skeleton {
    let mut s = Skeleton {
        joints: Vec::new(),
        body_height: 1.62,
        z_up: true,
        arms_down_deg: 40.0,
    };
    let mut above = None;
    let trunk = [
        ("Hips", PELVIS, Segment::Pelvis),
        ("Spine", LUMBAR, Segment::Lumbar),
        ("Chest", MIDRIFF, Segment::Midriff),
        ("UpperChest", THORAX, Segment::Thorax),
    ];
    for (part, position, segment) in trunk {
        above = Some(s.add(
            above,
            format!("J_Bip_C_{part}"),
            middle(position),
            segment,
            ORDER,
        ));
    }
    let neck = s.add(above, "J_Bip_C_Neck", middle(NECK), Segment::Neck, ORDER);
    let head = [middle(HEAD), middle(HEAD_TOP)];
    s.add_leaf(Some(neck), "J_Bip_C_Head", head, Segment::Head, ORDER);
    for side in Side::BOTH {
        arm(&mut s, above, side);
    }
    for side in Side::BOTH {
        leg(&mut s, side);
    }
    s
}

fn named(side: Side, part: &str) -> String {
    format!(
        "J_Bip_{}_{part}",
        if side == Side::Left { "L" } else { "R" }
    )
}

fn arm(s: &mut Skeleton, chest: Option<usize>, side: Side) {
    let name = |part: &str| named(side, part);
    let part = |limb| Segment::Limb(side, limb);
    let at = |point| on(side, point);
    let clavicle = s.add(
        chest,
        name("Shoulder"),
        at(CLAVICLE),
        part(Limb::Clavicle),
        ORDER,
    );
    let upper = s.add(
        Some(clavicle),
        name("UpperArm"),
        at(SHOULDER),
        part(Limb::UpperArm),
        ORDER,
    );
    let fore = s.add(
        Some(upper),
        name("LowerArm"),
        at(ELBOW),
        part(Limb::Forearm),
        ORDER,
    );
    let twist = [(at(ELBOW) + at(WRIST)) * 0.5, at(WRIST)];
    s.add_leaf(
        Some(fore),
        name("LowerArmTwist"),
        twist,
        part(Limb::Forearm),
        ORDER,
    );
    let hand = s.add(Some(fore), name("Hand"), at(WRIST), part(Limb::Hand), ORDER);
    for finger in FINGERS {
        add_finger(s, hand, side, finger);
    }
}

fn add_finger(
    s: &mut Skeleton,
    hand: usize,
    side: Side,
    (name, knuckle, reach): (&str, [f64; 3], [f64; 3]),
) {
    let limb = if name == "Thumb" {
        Limb::Hand
    } else {
        Limb::Fingers
    };
    let knuckle: Vector3<f64> = on(side, WRIST) + side.mirror(knuckle);
    let at = |share: f64| knuckle + side.mirror(reach) * share;
    let joint = |n: usize| named(side, &format!("{name}{n}"));
    let part = Segment::Limb(side, limb);
    let first = s.add(Some(hand), joint(1), at(0.0), part, ORDER);
    let second = s.add(Some(first), joint(2), at(0.45), part, ORDER);
    s.add_leaf(Some(second), joint(3), [at(0.75), at(1.0)], part, ORDER);
}

fn leg(s: &mut Skeleton, side: Side) {
    let name = |part: &str| named(side, part);
    let part = |limb| Segment::Limb(side, limb);
    let at = |point| on(side, point);
    let thigh = s.add(Some(0), name("UpperLeg"), at(HIP), part(Limb::Thigh), ORDER);
    let shin = s.add(
        Some(thigh),
        name("LowerLeg"),
        at(KNEE),
        part(Limb::Shin),
        ORDER,
    );
    let foot = s.add(Some(shin), name("Foot"), at(ANKLE), part(Limb::Foot), ORDER);
    s.add_leaf(
        Some(foot),
        name("ToeBase"),
        [at(BALL), at(TOE_TIP)],
        part(Limb::Toes),
        ORDER,
    );
}
