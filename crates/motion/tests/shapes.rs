//! Skeletons whose names say nothing: legs, arms and head by the shape.

mod support;

use motion::body::{self, Role, Source};
use motion::clip::Clip;
use serde_json::Value;

/// The clip with joints called j0, j1 … instead of their names.
fn nameless(clip: &Clip) -> Clip {
    let mut clip = clip.clone();
    for performer in &mut clip.performers {
        for (index, joint) in performer.skeleton.joints.iter_mut().enumerate() {
            joint.name = if joint.is_end_site {
                String::new()
            } else {
                format!("j{index}")
            };
        }
    }
    clip
}

fn rig(name: &str) -> Option<Clip> {
    let path = support::data_folder()?
        .join("rigs")
        .join(format!("{name}.bvh"));
    let bytes = std::fs::read(path).expect("a readable file");
    Some(motion::bvh::parse(&bytes).expect("a motion"))
}

/// Roles for which the shape says neither what the names say nor one of the alternatives.
fn differing(name: &str, alternatives: &Value) -> Vec<String> {
    let Some(clip) = rig(name) else {
        return Vec::new();
    };
    let by_name = body::find(&clip, 0, &[]);
    let by_shape = body::find(&nameless(&clip), 0, &[]);
    assert!(
        by_shape
            .joints
            .iter()
            .all(|joint| joint.source != Source::Name)
    );
    let labels = clip.performers[0].skeleton.labels();
    let label = |joint: Option<usize>| joint.map_or("none", |joint| labels[joint].as_str());
    let mut wrong = Vec::new();
    for role in Role::ALL {
        let (named, shaped) = (label(by_name.joint(*role)), label(by_shape.joint(*role)));
        let others = alternatives[role.name()].as_array();
        let is_other = others.is_some_and(|names| names.iter().any(|name| name == shaped));
        if named != shaped && !is_other {
            wrong.push(format!("{name}: {} is {shaped}, not {named}", role.name()));
        }
    }
    wrong
}

/// Rigs whose shape does not tell: left and right swapped against the feet; a bone as long as
/// the leg that only its name shows to be a helper.
const SHAPELESS: [&str; 2] = ["kinect_openni.bvh", "mass_dance.bvh"];

#[test]
fn rigs_without_names_are_found_by_their_shape() {
    let Some(folder) = support::data_folder() else {
        return;
    };
    let text = std::fs::read_to_string(folder.join("rigs.golden.json")).expect("the answers");
    let rigs: Vec<Value> = serde_json::from_str(&text).expect("JSON");
    let mut wrong = Vec::new();
    for rig in rigs.iter().filter(|rig| rig["kind"] == "human") {
        let name = rig["file"]
            .as_str()
            .expect("a name")
            .trim_end_matches(".bvh");
        if !SHAPELESS.iter().any(|file| rig["file"] == *file) {
            wrong.extend(differing(name, &rig["alternatives"]));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_choice_by_hand_stands_above_names_and_shape() {
    let Some(clip) = rig("aitviewer_sample") else {
        return;
    };
    let labels = clip.performers[0].skeleton.labels();
    let index = |label: &str| {
        labels
            .iter()
            .position(|other| other == label)
            .expect("a joint")
    };
    let chosen = [
        (Role::LeftAnkle, index("LeftToe")),
        (Role::Neck, index("Chest4")),
        (Role::Head, 9999),
    ];
    let body = body::find(&clip, 0, &chosen);
    assert_eq!(body.joint(Role::LeftAnkle), Some(index("LeftToe")));
    assert_eq!(body.joint(Role::LeftToe), Some(index("LeftToe/end")));
    assert_eq!(body.joint(Role::Neck), Some(index("Chest4")));
    assert_eq!(body.joint(Role::Head), Some(index("Head/end")));
    let by_hand = body
        .joints
        .iter()
        .filter(|joint| joint.source == Source::User);
    assert_eq!(by_hand.count(), 2);
}

#[test]
fn sixteen_choices_make_any_skeleton_a_body() {
    let Some(clip) = rig("dog") else {
        return;
    };
    let found = body::find(&clip, 0, &[]);
    assert!(!found.is_human());
    let chosen: Vec<_> = found
        .joints
        .iter()
        .map(|joint| (joint.role, joint.joint))
        .collect();
    assert!(body::find(&clip, 0, &chosen).is_human());
}
