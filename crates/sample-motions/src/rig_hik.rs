//! The rig of MotionBuilder and Mixamo.

use crate::body::{
    ANKLE, BALL, CLAVICLE, ELBOW, FINGER_TIP, HEAD, HEAD_TOP, HIP, KNEE, LUMBAR, Limb, MIDRIFF,
    NECK, PELVIS, SHOULDER, Segment, Side, THORAX, TOE_TIP, WRIST,
};
use crate::euler::Axis;
use crate::skeleton::{Skeleton, middle, on};

const ORDER: [Axis; 3] = [Axis::Z, Axis::X, Axis::Y];

pub fn skeleton() -> Skeleton {
    let mut s = Skeleton {
        joints: Vec::new(),
        body_height: 174.0,
        z_up: false,
        arms_down_deg: 0.0,
    };
    let hips = s.add(None, "Hips", middle(PELVIS), Segment::Pelvis, ORDER);
    for side in Side::BOTH {
        leg(&mut s, hips, side);
    }
    let spine = s.add(Some(hips), "Spine", middle(LUMBAR), Segment::Lumbar, ORDER);
    let spine1 = s.add(
        Some(spine),
        "Spine1",
        middle(MIDRIFF),
        Segment::Midriff,
        ORDER,
    );
    let spine2 = s.add(
        Some(spine1),
        "Spine2",
        middle(THORAX),
        Segment::Thorax,
        ORDER,
    );
    for side in Side::BOTH {
        arm(&mut s, spine2, side);
    }
    let neck = s.add(Some(spine2), "Neck", middle(NECK), Segment::Neck, ORDER);
    s.add_leaf(
        Some(neck),
        "Head",
        [middle(HEAD), middle(HEAD_TOP)],
        Segment::Head,
        ORDER,
    );
    s
}

fn leg(s: &mut Skeleton, hips: usize, side: Side) {
    let name = |part: &str| format!("{side:?}{part}");
    let part = |limb| Segment::Limb(side, limb);
    let thigh = s.add(
        Some(hips),
        name("UpLeg"),
        on(side, HIP),
        part(Limb::Thigh),
        ORDER,
    );
    let shin = s.add(
        Some(thigh),
        name("Leg"),
        on(side, KNEE),
        part(Limb::Shin),
        ORDER,
    );
    let foot = s.add(
        Some(shin),
        name("Foot"),
        on(side, ANKLE),
        part(Limb::Foot),
        ORDER,
    );
    let toes = [on(side, BALL), on(side, TOE_TIP)];
    s.add_leaf(Some(foot), name("ToeBase"), toes, part(Limb::Toes), ORDER);
}

fn arm(s: &mut Skeleton, chest: usize, side: Side) {
    let name = |part: &str| format!("{side:?}{part}");
    let part = |limb| Segment::Limb(side, limb);
    let at = |point| on(side, point);
    let clavicle = s.add(
        Some(chest),
        name("Shoulder"),
        at(CLAVICLE),
        part(Limb::Clavicle),
        ORDER,
    );
    let upper = s.add(
        Some(clavicle),
        name("Arm"),
        at(SHOULDER),
        part(Limb::UpperArm),
        ORDER,
    );
    let fore = s.add(
        Some(upper),
        name("ForeArm"),
        at(ELBOW),
        part(Limb::Forearm),
        ORDER,
    );
    let hand = [at(WRIST), at(FINGER_TIP)];
    s.add_leaf(Some(fore), name("Hand"), hand, part(Limb::Hand), ORDER);
}
