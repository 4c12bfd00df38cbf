//! Posture variation and each joint's part of it: postures of the 16 principal joints in, 12 numbers
//! and 16 × 12 parts that sum up to them out, in squared body heights.
//!
//! A frame's f_k is the sum over the joints of `c_k(j) = (x_a − c_a)(x_b − c_b) / 16` for the two axes
//! a, b of component k and the middle c of the joints. Joint j's part of the mean is the mean of c_k(j),
//! its part of the deviation `cov(c_k(j), f_k) / sd(f_k)`, 0 where the deviation is 0.

use super::PostureVariation;
use super::posture_variation::AXES;
use crate::body::PRINCIPAL_JOINTS;

/// Numbers of a posture: x, y, z of each principal joint.
pub(super) const WIDTH: usize = 3 * PRINCIPAL_JOINTS;

/// One number for each joint.
type Row = [f64; PRINCIPAL_JOINTS];

/// A feature with its parts.
#[derive(Clone, Debug, PartialEq)]
pub struct VariationOfJoints {
    /// The feature, bit for bit that of [`posture_variation`](super::posture_variation()).
    pub feature: [f64; 12],
    /// What each joint adds to it.
    pub by_joint: [[f64; 12]; PRINCIPAL_JOINTS],
}

/// Both while frames come in: one pass, with running means and products of deviations, so that no
/// large squares are subtracted.
#[derive(Clone, Debug, Default)]
pub struct JointVariation {
    whole: PostureVariation,
    /// The means of the products (x_a − c_a)(x_b − c_b), a row a component.
    means: [Row; 6],
    /// The sums of the products' deviations times those of f.
    moments: [Row; 6],
}

impl JointVariation {
    /// Adds a frame: x, y, z of joint after joint.
    pub fn add(&mut self, posture: &[f64; WIDTH]) {
        let centred = centred(posture);
        let products = AXES.map(|(a, b)| product(&centred[a], &centred[b]));
        let joints = PRINCIPAL_JOINTS as f64;
        let covariance =
            products.map(|row| row.iter().fold(0.0, |sum, value| sum + value) / joints);
        let deviation = self.whole.add_covariance(covariance);
        let part = 1.0 / self.whole.frames() as f64;
        for (component, row) in products.iter().enumerate() {
            let running = self.means[component].iter_mut();
            let running = running.zip(&mut self.moments[component]);
            for (value, (mean, moment)) in row.iter().zip(running) {
                let before = value - *mean;
                *mean += before * part;
                *moment += before * deviation[component];
            }
        }
    }

    /// Feature and parts of the frames added; zeros without any.
    pub fn finish(&self) -> VariationOfJoints {
        let feature = self.whole.feature();
        let frames = self.whole.frames().max(1) as f64;
        let part = |joint: usize, index: usize| match (index, feature[index]) {
            (0..6, _) => self.means[index][joint],
            (_, 0.0) => 0.0,
            (_, deviation) => self.moments[index - 6][joint] / frames / deviation,
        };
        let joints = PRINCIPAL_JOINTS as f64;
        VariationOfJoints {
            feature,
            by_joint: core::array::from_fn(|joint| {
                core::array::from_fn(|index| part(joint, index) / joints)
            }),
        }
    }
}

/// The coordinates from the middle of the joints: a row of x, one of y, one of z.
fn centred(posture: &[f64; WIDTH]) -> [Row; 3] {
    [0, 1, 2].map(|axis| {
        let row: Row = core::array::from_fn(|joint| posture[3 * joint + axis]);
        let sum = row.iter().fold(0.0, |sum, value| sum + value);
        let middle = sum / PRINCIPAL_JOINTS as f64;
        row.map(|value| value - middle)
    })
}

fn product(one: &Row, other: &Row) -> Row {
    core::array::from_fn(|joint| one[joint] * other[joint])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::feature::posture_variation;
    use crate::track::PelvisTrack;
    use test_support::Random;

    fn postures(frames: usize, middle: f64) -> Vec<[f64; WIDTH]> {
        let mut random = Random::new(7);
        let mut posture = || core::array::from_fn(|_| middle + 2.0 * random.unit() - 1.0);
        (0..frames).map(|_| posture()).collect()
    }

    fn variation(postures: &[[f64; WIDTH]]) -> VariationOfJoints {
        let mut variation = JointVariation::default();
        for posture in postures {
            variation.add(posture);
        }
        variation.finish()
    }

    /// The definition, in two passes.
    fn plain(postures: &[[f64; WIDTH]]) -> [[f64; 12]; PRINCIPAL_JOINTS] {
        let count = postures.len() as f64;
        let mean = |of: &dyn Fn(&[f64; WIDTH]) -> f64| postures.iter().map(of).sum::<f64>() / count;
        let added = |posture: &[f64; WIDTH], joint: usize, (a, b): (usize, usize)| {
            let middle = |axis: usize| posture.iter().skip(axis).step_by(3).sum::<f64>() / 16.0;
            let from = |axis: usize| posture[3 * joint + axis] - middle(axis);
            from(a) * from(b) / 16.0
        };
        let whole = |posture: &[f64; WIDTH], axes| {
            (0..16)
                .map(|joint| added(posture, joint, axes))
                .sum::<f64>()
        };
        core::array::from_fn(|joint| {
            core::array::from_fn(|index| {
                let axes = AXES[index % 6];
                let mean_part = mean(&|posture| added(posture, joint, axes));
                if index < 6 {
                    return mean_part;
                }
                let mean_whole = mean(&|posture| whole(posture, axes));
                let square = mean(&|posture| {
                    let from = whole(posture, axes) - mean_whole;
                    from * from
                });
                let covariance = mean(&|posture| {
                    (added(posture, joint, axes) - mean_part) * (whole(posture, axes) - mean_whole)
                });
                covariance / square.sqrt()
            })
        })
    }

    #[test]
    fn parts_are_those_of_the_definition() {
        let postures = postures(40, 0.3);
        let (found, plain) = (variation(&postures), plain(&postures));
        for (found, plain) in found.by_joint.iter().zip(&plain) {
            for (found, plain) in found.iter().zip(plain) {
                assert!((found - plain).abs() < 1e-14, "{found} is not {plain}");
            }
        }
    }

    #[test]
    fn the_feature_is_the_same_to_the_bit_and_the_sum_of_its_parts() {
        let postures = postures(500, 0.1);
        let found = variation(&postures);
        let track = PelvisTrack {
            coordinates: postures.concat(),
            joint_count: PRINCIPAL_JOINTS,
            first_frame: 0,
        };
        assert_eq!(found.feature, posture_variation(&track));
        for index in 0..12 {
            let sum: f64 = found.by_joint.iter().map(|part| part[index]).sum();
            assert!((sum - found.feature[index]).abs() < 1e-14);
        }
    }

    #[test]
    fn a_far_origin_costs_no_digits() {
        let (near, far) = (
            variation(&postures(300, 0.0)),
            variation(&postures(300, 1024.0)),
        );
        for (near, far) in near
            .by_joint
            .as_flattened()
            .iter()
            .zip(far.by_joint.as_flattened())
        {
            assert!((near - far).abs() < 1e-11);
        }
    }

    #[test]
    fn a_held_posture_has_no_deviation_and_nothing_is_zero() {
        let held = variation(&[[0.25; WIDTH]; 9]);
        assert!(held.by_joint.iter().all(|part| *part == [0.0; 12]));
        assert_eq!(variation(&[]).feature, [0.0; 12]);
        let posture = postures(1, 0.0)[0];
        let one = variation(&[posture; 3]);
        assert!(one.by_joint.iter().all(|part| part[6..] == [0.0; 6]));
    }
}
