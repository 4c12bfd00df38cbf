//! Dissimilarities of clips: two clips' features in, one number in squared body heights out.
//!
//! [`Distance`] is the one place where the next dissimilarity is added: a variant, and its arm in each
//! function here.

use crate::feature::{ClipFeature, FEATURE_LENGTH, JOINTS, Vector};

/// The numbers that change their sign in a mirrored motion: the means of σ_xy and σ_zx. (Deviations
/// have no sign.)
const MIRRORED: [usize; 2] = [3, 5];

/// Principal joints of one side: the left ones come first, then the right ones in the same order.
const JOINTS_OF_A_SIDE: usize = 7;

/// How alike two clips are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Distance {
    /// The Euclidean distance of the posture-variation features (Miura et al. 2013, eq. 1–3).
    PostureVariation(Dissimilarity),
}

/// The choices of the posture variation; by default neither.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Dissimilarity {
    /// Whether the motions are compared on a body of standard lengths.
    pub across_rigs: bool,
    /// Whether a motion is as near as its mirror image: min(d(a, b), d(a, M b)).
    pub mirror_aware: bool,
}

/// A distance, and whether it is that to the mirror image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// In squared body heights.
    pub value: f64,
    /// Whether the mirror image of the second clip is nearer than the clip.
    pub mirrored: bool,
}

impl Default for Distance {
    fn default() -> Self {
        Distance::PostureVariation(Dissimilarity::default())
    }
}

impl Distance {
    /// The distance of two clips.
    pub fn between(self, a: &ClipFeature, b: &ClipFeature) -> Measured {
        let Distance::PostureVariation(choice) = self;
        let (a, b) = (self.vector(a), self.vector(b));
        let value = euclidean(a, b);
        if !choice.mirror_aware {
            return Measured {
                value,
                mirrored: false,
            };
        }
        let to_mirror = euclidean(a, &mirror(b));
        Measured {
            value: value.min(to_mirror),
            mirrored: to_mirror < value,
        }
    }

    /// The feature of a clip that is compared.
    pub fn vector(self, clip: &ClipFeature) -> &Vector {
        let Distance::PostureVariation(choice) = self;
        match choice.across_rigs {
            true => &clip.across_rigs,
            false => &clip.recorded,
        }
    }

    /// The parts of that feature.
    pub fn by_joint(self, clip: &ClipFeature) -> &[Vector; JOINTS] {
        let Distance::PostureVariation(choice) = self;
        match choice.across_rigs {
            true => &clip.across_rigs_by_joint,
            false => &clip.recorded_by_joint,
        }
    }
}

/// The Euclidean distance of two features.
pub fn euclidean(a: &Vector, b: &Vector) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
    squares.fold(0.0, |sum, square| sum + square).sqrt()
}

/// M: the feature of the mirrored motion.
pub fn mirror(vector: &Vector) -> Vector {
    core::array::from_fn(|index| match MIRRORED.contains(&index) {
        true => -vector[index],
        false => vector[index],
    })
}

/// What each joint adds to [`mirror`] of the feature: left and right change places.
pub fn mirror_by_joint(by_joint: &[Vector; JOINTS]) -> [Vector; JOINTS] {
    core::array::from_fn(|joint| mirror(&by_joint[mirror_joint(joint)]))
}

/// The joint of the other side; neck and head are their own.
pub fn mirror_joint(joint: usize) -> usize {
    match joint {
        ..JOINTS_OF_A_SIDE => joint + JOINTS_OF_A_SIDE,
        _ if joint < 2 * JOINTS_OF_A_SIDE => joint - JOINTS_OF_A_SIDE,
        _ => joint,
    }
}

const _: () = assert!(FEATURE_LENGTH == 12 && JOINTS == 2 * JOINTS_OF_A_SIDE + 2);

#[cfg(test)]
mod tests {
    use super::*;

    fn clip(recorded: Vector, across_rigs: Vector) -> ClipFeature {
        ClipFeature {
            recorded,
            across_rigs,
            recorded_by_joint: [[0.0; FEATURE_LENGTH]; JOINTS],
            across_rigs_by_joint: [[1.0; FEATURE_LENGTH]; JOINTS],
        }
    }

    fn distance(across_rigs: bool, mirror_aware: bool) -> Distance {
        Distance::PostureVariation(Dissimilarity {
            across_rigs,
            mirror_aware,
        })
    }

    const ZERO: Vector = [0.0; FEATURE_LENGTH];

    fn with(pairs: &[(usize, f64)]) -> Vector {
        let mut vector = ZERO;
        for (index, value) in pairs {
            vector[*index] = *value;
        }
        vector
    }

    #[test]
    fn a_choice_takes_its_feature() {
        let a = clip(ZERO, ZERO);
        let b = clip(with(&[(0, 3.0), (7, -4.0)]), with(&[(2, 2.0)]));
        assert_eq!(Distance::default().between(&a, &b).value, 5.0);
        assert_eq!(distance(true, false).between(&a, &b).value, 2.0);
        assert_eq!(distance(true, false).by_joint(&a)[0][0], 1.0);
        assert_eq!(distance(false, false).by_joint(&a)[0][0], 0.0);
    }

    #[test]
    fn the_nearer_of_a_clip_and_its_mirror_image_counts() {
        let a = clip(with(&[(3, 1.0), (5, 1.0), (9, 1.0)]), ZERO);
        let b = clip(with(&[(3, -1.0), (5, -1.0), (9, -1.0)]), ZERO);
        let found = distance(false, true).between(&a, &b);
        assert_eq!((found.value, found.mirrored), (2.0, true));
        let same = distance(false, true).between(&a, &a);
        assert_eq!((same.value, same.mirrored), (0.0, false));
        let straight = clip(with(&[(0, 1.0)]), ZERO);
        let tie = distance(false, true).between(&straight, &clip(ZERO, ZERO));
        assert_eq!((tie.value, tie.mirrored), (1.0, false));
    }

    #[test]
    fn a_mirror_image_has_its_sides_changed() {
        let mut by_joint = [ZERO; JOINTS];
        by_joint[2] = with(&[(3, 1.0), (4, 2.0), (9, 3.0)]);
        by_joint[15] = with(&[(5, 1.0)]);
        let found = mirror_by_joint(&by_joint);
        assert_eq!(found[9], with(&[(3, -1.0), (4, 2.0), (9, 3.0)]));
        assert_eq!(found[15], with(&[(5, -1.0)]));
        assert_eq!(mirror_by_joint(&found), by_joint);
    }
}
