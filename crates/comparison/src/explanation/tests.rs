//! Explanations worked out by hand, and their sums.

use super::*;
use crate::distance::Dissimilarity;
use test_support::Random;

/// A clip whose feature is the sum of the given parts of joints.
fn clip(parts: &[(usize, usize, f64)]) -> ClipFeature {
    let mut by_joint = [[0.0; FEATURE_LENGTH]; JOINTS];
    for (joint, index, value) in parts {
        by_joint[*joint][*index] += value;
    }
    of_joints(by_joint)
}

fn of_joints(by_joint: [Vector; JOINTS]) -> ClipFeature {
    let mut whole = [0.0; FEATURE_LENGTH];
    for part in &by_joint {
        for (sum, value) in whole.iter_mut().zip(part) {
            *sum += value;
        }
    }
    ClipFeature {
        recorded: whole,
        across_rigs: whole,
        recorded_by_joint: by_joint,
        across_rigs_by_joint: by_joint,
    }
}

fn random_clip(random: &mut Random) -> ClipFeature {
    of_joints(core::array::from_fn(|_| {
        core::array::from_fn(|_| random.unit() - 0.5)
    }))
}

fn explained(a: &ClipFeature, b: &ClipFeature) -> Explanation {
    explain(Distance::default(), a, b)
}

#[test]
fn shares_of_components_joints_and_parts_sum_up_to_one() {
    let mut random = Random::new(3);
    let mirror_aware = Distance::PostureVariation(Dissimilarity {
        across_rigs: true,
        mirror_aware: true,
    });
    for _ in 0..100 {
        let (a, b) = (random_clip(&mut random), random_clip(&mut random));
        for distance in [Distance::default(), mirror_aware] {
            let found = explain(distance, &a, &b);
            let sums = [
                found.shares.iter().sum::<f64>(),
                found.joint_shares.iter().sum(),
                found.part_shares.iter().sum(),
            ];
            assert!(sums.iter().all(|sum| (sum - 1.0).abs() < 1e-12), "{sums:?}");
        }
    }
}

#[test]
fn a_leg_that_reaches_further_is_named() {
    // The left knee adds 4 of 4 to the height, a wrist 2 of 2 to how much the lean changes.
    let a = clip(&[(4, 1, 4.0)]);
    let b = clip(&[(9, 10, 2.0)]);
    let found = explained(&a, &b);
    assert_eq!(found.distance.value, 20.0_f64.sqrt());
    assert!((found.shares[1] - 0.8).abs() < 1e-15);
    assert!((found.shares[10] - 0.2).abs() < 1e-15);
    assert!((found.part_shares[2] - 0.8).abs() < 1e-15);
    assert!((found.part_shares[1] - 0.2).abs() < 1e-15);
    let Sentence::Component {
        component,
        of,
        share,
        larger,
        parts,
    } = found.sentence
    else {
        panic!("{:?}", found.sentence)
    };
    assert_eq!((component, of, larger), (1, Half::Mean, Which::A));
    assert!((share - 0.8).abs() < 1e-15);
    assert_eq!(parts, [2]);
}

#[test]
fn mean_and_deviation_of_a_component_are_one_share() {
    // Squares 9 and 16 of 25; the deviation is the larger and b's.
    let a = clip(&[(0, 5, -3.0)]);
    let b = clip(&[(7, 11, 4.0)]);
    let found = explained(&a, &b).sentence;
    let expected = Sentence::Component {
        component: 5,
        of: Half::Deviation,
        share: 9.0 / 25.0 + 16.0 / 25.0,
        larger: Which::B,
        parts: vec![1, 0],
    };
    assert_eq!(found, expected);
}

#[test]
fn a_covariance_is_larger_by_its_size() {
    let found = explained(&clip(&[(0, 4, -3.0)]), &clip(&[(0, 4, 1.0)])).sentence;
    assert!(matches!(
        found,
        Sentence::Component {
            larger: Which::A,
            ..
        }
    ));
}

#[test]
fn a_part_that_makes_them_more_alike_is_negative_and_not_named() {
    let a = clip(&[(0, 0, 3.0), (14, 0, -1.0)]);
    let found = explained(&a, &clip(&[]));
    assert_eq!(found.part_shares, [1.5, 0.0, 0.0, 0.0, -0.5]);
    assert!(matches!(found.sentence, Sentence::Component { parts, .. } if parts == [0]));
}

#[test]
fn nothing_outstanding_is_a_little_of_everything() {
    let a = clip(&[(4, 0, 1.0), (4, 1, 1.0), (4, 2, 1.0)]);
    let found = explained(&a, &clip(&[])).sentence;
    assert_eq!(found, Sentence::Everything { parts: vec![2] });
}

#[test]
fn the_same_has_no_shares() {
    let a = clip(&[(3, 2, 1.0)]);
    let found = explained(&a, &a);
    assert_eq!(found.sentence, Sentence::Same);
    assert_eq!(found.shares, [0.0; FEATURE_LENGTH]);
    assert_eq!(found.part_shares, [0.0; PARTS]);
    let near = clip(&[(3, 2, 1.0 + 5e-10)]);
    assert_eq!(explained(&a, &near).sentence, Sentence::Same);
}

#[test]
fn a_mirrored_clip_is_explained_by_its_mirror_image() {
    // b is a with left and right changed, but for its right wrist, a's left one.
    let a = clip(&[(2, 3, 1.0), (5, 0, 1.0)]);
    let b = clip(&[(9, 3, -1.0), (12, 0, 1.0), (9, 0, 0.5)]);
    let mirror_aware = Distance::PostureVariation(Dissimilarity {
        across_rigs: false,
        mirror_aware: true,
    });
    let found = explain(mirror_aware, &a, &b);
    assert_eq!((found.distance.value, found.distance.mirrored), (0.5, true));
    assert_eq!(found.joint_shares[2], 1.0);
    assert_eq!(found.part_shares, [1.0, 0.0, 0.0, 0.0, 0.0]);
}
