//! Postures side by side: frames × joints × (x, y, z) in, mean joint distances between frames out, four
//! frames at once.

use crate::distance::mirror_joint;
use crate::feature::JOINTS;
use core::ops::Range;
use wide::f64x4;

/// Numbers of a posture.
const WIDTH: usize = 3 * JOINTS;

/// Frames that are compared at once.
pub const LANES: usize = 4;

/// x, y, z of joint after joint, in pelvis coordinates.
pub type Posture = [f64; WIDTH];

/// The frames of a row of coordinates; what is left over is no frame.
pub fn split(coordinates: &[f64]) -> Vec<Posture> {
    coordinates.as_chunks::<WIDTH>().0.to_vec()
}

/// The same motion in a mirror: left and right joints change places, x its sign.
pub fn mirror_postures(coordinates: &[f64]) -> Vec<f64> {
    let mirror = |posture: &Posture| -> Posture {
        core::array::from_fn(|index| {
            let value = posture[3 * mirror_joint(index / 3) + index % 3];
            if index % 3 == 0 { -value } else { value }
        })
    };
    split(coordinates).iter().flat_map(mirror).collect()
}

/// The Euclidean distance of each joint in two postures.
pub fn joint_distances(a: &Posture, b: &Posture) -> [f64; JOINTS] {
    core::array::from_fn(|joint| {
        let [x, y, z] = [0, 1, 2].map(|axis| a[3 * joint + axis] - b[3 * joint + axis]);
        (x * x + y * y + z * z).sqrt()
    })
}

/// Postures, four beside each other.
#[derive(Clone, Debug)]
pub struct Blocks {
    /// How many postures there are; the last block is filled up with zeros.
    pub frames: usize,
    blocks: Vec<[f64x4; WIDTH]>,
}

impl Blocks {
    /// All of these.
    pub fn new(postures: &[Posture]) -> Self {
        let block = |postures: &[Posture]| {
            core::array::from_fn(|index| {
                f64x4::new(core::array::from_fn(|lane| {
                    postures.get(lane).map_or(0.0, |posture| posture[index])
                }))
            })
        };
        Self {
            frames: postures.len(),
            blocks: postures.chunks(LANES).map(block).collect(),
        }
    }

    /// One of them.
    pub fn posture(&self, frame: usize) -> Posture {
        let block = &self.blocks[frame / LANES];
        core::array::from_fn(|index| block[index].to_array()[frame % LANES])
    }

    /// The mean joint distances of `postures` (at most as many as `to` has rows) to the frames of `blocks`;
    /// a row of `to` is as wide as the blocks.
    pub fn distances(&self, postures: &[Posture], blocks: Range<usize>, to: &mut [f64]) {
        let width = blocks.len() * LANES;
        for (place, block) in self.blocks[blocks].iter().enumerate() {
            for (posture, row) in postures.iter().zip(to.chunks_exact_mut(width)) {
                let means = mean_distances(posture, block).to_array();
                row[place * LANES..(place + 1) * LANES].copy_from_slice(&means);
            }
        }
    }
}

/// The mean joint distances of one posture to four.
fn mean_distances(posture: &Posture, block: &[f64x4; WIDTH]) -> f64x4 {
    let mut sum = f64x4::ZERO;
    let joints = posture.as_chunks::<3>().0.iter();
    for (joint, others) in joints.zip(block.as_chunks::<3>().0) {
        let x = f64x4::splat(joint[0]) - others[0];
        let y = f64x4::splat(joint[1]) - others[1];
        let z = f64x4::splat(joint[2]) - others[2];
        sum += (x * x + y * y + z * z).sqrt();
    }
    sum * f64x4::splat(1.0 / JOINTS as f64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use test_support::Random;

    fn postures(count: usize) -> Vec<Posture> {
        let mut random = Random::new(2);
        let mut posture = || core::array::from_fn(|_| random.unit());
        (0..count).map(|_| posture()).collect()
    }

    #[test]
    fn four_at_once_are_those_of_one_by_one() {
        let (a, b) = (postures(3), postures(10));
        let blocks = Blocks::new(&b);
        let mut found = vec![0.0; 3 * 8];
        blocks.distances(&a, 1..3, &mut found);
        for (row, posture) in a.iter().enumerate() {
            for (column, frame) in (4..10).enumerate() {
                let sum = joint_distances(posture, &b[frame])
                    .iter()
                    .fold(0.0, |sum, value| sum + value);
                assert_eq!(found[8 * row + column], sum / 16.0);
            }
        }
        for (frame, posture) in b.iter().enumerate() {
            assert_eq!(blocks.posture(frame), *posture);
        }
    }

    #[test]
    fn a_mirror_changes_sides_and_signs() {
        let posture: Posture = core::array::from_fn(|index| index as f64);
        let found = mirror_postures(&posture);
        // The right shoulder is joint 7, the head joint 15.
        assert_eq!(found[..3], [-21.0, 22.0, 23.0]);
        assert_eq!(found[21..24], [-0.0, 1.0, 2.0]);
        assert_eq!(found[45..], [-45.0, 46.0, 47.0]);
        assert_eq!(mirror_postures(&found), posture);
    }
}
