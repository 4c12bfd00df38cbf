//! The same trial on two rigs, and how well both features tell real clips apart.

#[path = "support/recordings.rs"]
mod recordings;
mod support;

use comparison::cut::bic;
use comparison::distance::{Dissimilarity, Distance};
use comparison::distances::Distances;
use comparison::evaluation::{clustering, leave_one_out};
use comparison::feature::ClipFeature;
use comparison::linkage;
use comparison::neighbours::nearest_first;
use recordings::recording;
use support::{data_folder, golden};

const RECORDED: Distance = distance(false);
const ACROSS_RIGS: Distance = distance(true);

const fn distance(across_rigs: bool) -> Distance {
    Distance::PostureVariation(Dissimilarity {
        across_rigs,
        mirror_aware: false,
    })
}

/// The clips of the reference, in its order.
fn clips() -> Option<(Vec<String>, Vec<ClipFeature>)> {
    let names: Vec<String> = golden()?["clips"]
        .as_array()?
        .iter()
        .filter_map(|name| Some(name.as_str()?.to_owned()))
        .collect();
    let folder = data_folder()?.join("cmu");
    let feature = |name: &String| recording(&folder.join(format!("{name}.bvh"))).feature;
    let features = names.iter().map(feature).collect();
    Some((names, features))
}

/// The place of clip `other` among the neighbours of clip `of`, from 1.
fn rank(distance: Distance, clips: &[ClipFeature], of: usize, other: usize) -> usize {
    let to = |clip| distance.between(&clips[of], clip).value;
    let distances: Vec<f64> = clips.iter().map(to).collect();
    let order = nearest_first(&distances, of);
    1 + order
        .iter()
        .position(|item| *item == other)
        .expect("a clip")
}

/// Subjects, the first two letters of the names, as labels.
fn labels(names: &[String]) -> Vec<Option<usize>> {
    let mut subjects: Vec<&str> = names.iter().map(|name| &name[..2]).collect();
    let all = subjects.clone();
    subjects.dedup();
    let label = |subject: &&str| subjects.iter().position(|other| other == subject);
    all.iter().map(label).collect()
}

/// Both ranks of a trial on two rigs, from each other among all clips.
fn ranks(
    distance: Distance,
    clips: &[ClipFeature],
    place: usize,
    twin: &ClipFeature,
) -> [usize; 2] {
    let mut with_twin = clips.to_vec();
    with_twin.push(twin.clone());
    let twin_place = clips.len();
    [
        rank(distance, &with_twin, place, twin_place),
        rank(distance, &with_twin, twin_place, place),
    ]
}

#[test]
fn the_same_trial_on_two_rigs_is_nearest_on_a_standard_body() {
    let (Some((names, clips)), Some(folder)) = (clips(), data_folder()) else {
        return;
    };
    let twin = recording(&folder.join("rigs/seen_cmu_daz_05_11.bvh")).feature;
    let place = names
        .iter()
        .position(|name| name == "05_11")
        .expect("the trial");
    let ranks = [RECORDED, ACROSS_RIGS].map(|distance| ranks(distance, &clips, place, &twin));
    // As recorded, the other rig's shoulders, half as wide (σ_xx), bring one other trial nearer.
    assert_eq!(ranks, [[1, 2], [1, 1]]);
    let between = |distance: Distance| distance.between(&clips[place], &twin).value;
    assert!(between(ACROSS_RIGS) < 0.65 * between(RECORDED));
}

#[test]
fn both_features_tell_the_subjects_apart_as_well() {
    let Some((names, clips)) = clips() else {
        return;
    };
    let labels = labels(&names);
    for distance in [RECORDED, ACROSS_RIGS] {
        let found = leave_one_out(&labels, |one, other| {
            distance.between(&clips[one], &clips[other]).value
        });
        // The one error is the only clip of its subject.
        assert_eq!(
            (found.labelled, found.correct, found.single.len()),
            (39, 38, 1)
        );
        let distances = Distances::of(distance, &clips);
        let vectors = distances.vectors().expect("vectors");
        let tree = linkage::ward(vectors);
        let clusters = bic::best(&bic::bic(vectors, &tree));
        let scores = clustering(&tree.cut(clusters), &labels);
        assert_eq!(clusters, 13);
        assert!((scores.f - 0.7017).abs() < 1e-4, "{scores:?}");
    }
}
