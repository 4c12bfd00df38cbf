//! The pelvis frame step by step on skeletons that each need another rule, and odd skeletons.

mod support;

use motion::body::{self, PelvisFrame, PoseTable, Role, TableBuilder};
use motion::clip::Clip;
use motion::note::{Note, NoteKind};
use support::analysed;

/// A person of 30 trunk, 40 + 40 leg; `{hips}` and `{spine}` are OFFSETs to fill in.
const PERSON: &str = "HIERARCHY
ROOT Hips { OFFSET 0 0 0 CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Spine { OFFSET {spine} CHANNELS 3 Zrotation Xrotation Yrotation
    JOINT Neck { OFFSET {neck} CHANNELS 3 Zrotation Xrotation Yrotation
      JOINT Head { OFFSET 0 8 0 CHANNELS 3 Zrotation Xrotation Yrotation End Site { OFFSET 0 15 0 } } }
    JOINT LeftArm { OFFSET 15 20 0 CHANNELS 3 Zrotation Xrotation Yrotation
      JOINT LeftForeArm { OFFSET 27 0 0 CHANNELS 3 Zrotation Xrotation Yrotation
        JOINT LeftHand { OFFSET 25 0 0 CHANNELS 3 Zrotation Xrotation Yrotation End Site { OFFSET 9 0 0 } } } }
    JOINT RightArm { OFFSET -15 20 0 CHANNELS 3 Zrotation Xrotation Yrotation
      JOINT RightForeArm { OFFSET -27 0 0 CHANNELS 3 Zrotation Xrotation Yrotation
        JOINT RightHand { OFFSET -25 0 0 CHANNELS 3 Zrotation Xrotation Yrotation End Site { OFFSET -9 0 0 } } } } }
  JOINT LeftUpLeg { OFFSET {left} CHANNELS {hip channels}
    JOINT LeftLeg { OFFSET 0 -40 0 CHANNELS 3 Zrotation Xrotation Yrotation
      JOINT LeftFoot { OFFSET 0 -40 0 CHANNELS 3 Zrotation Xrotation Yrotation End Site { OFFSET 0 -5 15 } } } }
  JOINT RightUpLeg { OFFSET {right} CHANNELS {hip channels}
    JOINT RightLeg { OFFSET 0 -40 0 CHANNELS 3 Zrotation Xrotation Yrotation
      JOINT RightFoot { OFFSET 0 -40 0 CHANNELS 3 Zrotation Xrotation Yrotation End Site { OFFSET 0 -5 15 } } } }
}
MOTION
Frames: 2
Frame Time: 0.01
";

struct Person {
    spine: &'static str,
    neck: &'static str,
    left: &'static str,
    right: &'static str,
    /// The value of the channels of the two hips; positions where there are six.
    hips: [&'static str; 2],
    /// Zrotation, Xrotation, Yrotation of the spine.
    bend: &'static str,
}

const PLAIN: Person = Person {
    spine: "0 10 0",
    neck: "0 22 0",
    left: "9 0 0",
    right: "-9 0 0",
    hips: ["0 0 0", "0 0 0"],
    bend: "0 0 0",
};

fn clip(person: &Person) -> Clip {
    let has_positions = person.hips[0].split(' ').count() > 3;
    let hip_channels = match has_positions {
        true => "6 Xposition Yposition Zposition Zrotation Xrotation Yrotation",
        false => "3 Zrotation Xrotation Yrotation",
    };
    let mut text = PERSON.to_owned();
    for (place, value) in [
        ("{spine}", person.spine),
        ("{neck}", person.neck),
        ("{left}", person.left),
        ("{right}", person.right),
        ("{hip channels}", hip_channels),
    ] {
        text = text.replace(place, value);
    }
    let zeros = |joints: usize| "0 0 0 ".repeat(joints);
    let [left, right] = person.hips;
    let row = format!(
        "0 90 0 0 0 0 {} {}{left} {}{right} {}\n",
        person.bend,
        zeros(8),
        zeros(2),
        zeros(2)
    );
    text += &row.repeat(2);
    motion::bvh::parse(text.as_bytes()).expect("a motion")
}

fn table(clip: &Clip, body: &body::Body) -> PoseTable {
    let mut builder = TableBuilder::new(clip, 0, body);
    assert!(builder.step(clip.frames));
    builder.finish()
}

fn frame(person: &Person) -> PelvisFrame {
    let clip = clip(person);
    let body = body::find(&clip, 0, &[]);
    assert!(body.is_human());
    PelvisFrame::new(&clip, 0, &body, &table(&clip, &body), 0)
}

fn kinds(notes: &[Note]) -> Vec<NoteKind> {
    notes.iter().map(|note| note.kind).collect()
}

#[test]
fn a_plain_person_faces_forward() {
    let frame = frame(&PLAIN);
    assert_eq!(frame.notes, []);
    assert_eq!(frame.axes, nalgebra::Matrix3::identity());
    assert_eq!(frame.origin, nalgebra::Vector3::zeros());
    assert!((frame.height - 1.2 * (30.0 + 80.0)).abs() < 1e-12);
}

#[test]
fn hips_that_lie_together_are_taken_from_the_motion() {
    let person = Person {
        left: "0 0 0",
        right: "0 0 0",
        hips: ["8 -2 0 0 0 0", "-8 -2 0 0 0 0"],
        ..PLAIN
    };
    let moved = frame(&person);
    // The OFFSETs are zero and there are positions: the rest pose has their mean already.
    assert_eq!(moved.notes, []);
    assert_eq!(moved.origin, nalgebra::Vector3::new(0.0, -2.0, 0.0));
    let close = Person {
        left: "0.5 0 0",
        right: "-0.5 0 0",
        ..person
    };
    let close = frame(&close);
    assert_eq!(kinds(&close.notes), [NoteKind::HipsTogether]);
    assert_eq!(close.axes, nalgebra::Matrix3::identity());
    assert_eq!(close.origin, nalgebra::Vector3::new(0.0, -2.0, 0.0));
}

#[test]
fn without_left_and_right_there_are_root_coordinates() {
    let person = Person {
        left: "0 0 0",
        right: "0 0 0",
        ..PLAIN
    };
    let frame = frame(&person);
    assert!(frame.is_root);
    assert_eq!(
        kinds(&frame.notes),
        [
            NoteKind::HipsTogether,
            NoteKind::RestIsNoBody,
            NoteKind::NoLeftAndRight
        ]
    );
    assert_eq!(frame.axes, nalgebra::Matrix3::identity());
}

#[test]
fn a_trunk_laid_along_the_hips_comes_from_the_motion() {
    let person = Person {
        spine: "10 0 0",
        neck: "22 0 0",
        bend: "90 0 0",
        ..PLAIN
    };
    let frame = frame(&person);
    assert_eq!(
        kinds(&frame.notes),
        [NoteKind::RestIsNoBody, NoteKind::TrunkFromMotion]
    );
    let up = frame.axes.row(1);
    assert!((up[1] - 1.0).abs() < 1e-12, "{up}");
}

#[test]
fn tracks_in_steps_and_at_once_are_the_same() {
    let clip = clip(&PLAIN);
    let body = body::find(&clip, 0, &[]);
    let whole = analysed(&clip, &body, table(&clip, &body));
    let mut builder = TableBuilder::new(&clip, 0, &body);
    while !builder.step(1) {}
    let stepped = analysed(&clip, &body, builder.finish());
    assert_eq!(whole, stepped);
    assert_eq!(whole.track, body::track(&clip, 0, &body, &whole.frame, 0));
    let head = 3 * Role::Head.index();
    let expected = [0.0, 55.0 / 132.0, 0.0];
    assert_eq!(whole.track.frame(1)[head..head + 3], expected);
}

/// A skeleton of `count` joints, each below the joint that `parent` says.
fn tree(count: usize, name: impl Fn(usize) -> String, parent: impl Fn(usize) -> usize) -> Clip {
    let mut clip = clip(&PLAIN);
    let mut joints = Vec::new();
    for index in 0..count {
        let mut joint = clip.performers[0].skeleton.joints[0].clone();
        joint.name = name(index);
        joint.parent = (index > 0).then(|| parent(index));
        joint.offset = nalgebra::Vector3::new(1.0, 2.0, 0.0);
        joint.channels = Vec::new();
        joint.first_channel = 0;
        joints.push(joint);
    }
    clip.performers[0].skeleton.joints = joints;
    clip
}

#[test]
fn large_and_odd_skeletons_are_searched_in_no_time() {
    let started = std::time::Instant::now();
    let names =
        |index: usize| ["LeftLeg", "LeftFoot", "LeftUpLeg", "Head", "x"][index % 5].to_owned();
    let shapes: [&dyn Fn(usize) -> usize; 4] =
        [&|index| index - 1, &|_| 0, &|index| index / 2, &|index| {
            index.saturating_sub(7)
        }];
    for parent in shapes {
        let clip = tree(10_000, names, parent);
        let body = body::find(
            &clip,
            0,
            &[(Role::Head, 1), (Role::Neck, 5), (Role::Pelvis, 10_000)],
        );
        assert!(!body.is_human());
        analysed(&clip, &body, table(&clip, &body));
    }
    assert!(started.elapsed().as_secs() < 20, "{:?}", started.elapsed());
}

#[test]
fn any_choice_of_joints_gives_finite_coordinates() {
    let clip = clip(&PLAIN);
    let joints = clip.performers[0].skeleton.joints.len();
    for shift in 0..joints {
        let chosen: Vec<_> = Role::ALL
            .iter()
            .map(|role| (*role, (role.index() * 5 + shift) % joints))
            .collect();
        let body = body::find(&clip, 0, &chosen);
        assert!(body.is_human());
        let found = analysed(&clip, &body, table(&clip, &body));
        assert!(found.frame.height > 0.0);
        assert!(
            found
                .track
                .coordinates
                .iter()
                .all(|value| value.is_finite())
        );
    }
}
