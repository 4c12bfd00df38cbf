//! Vectors as features of motions lie: a number of them goes in, heaps of different width come out, always
//! the same.

/// Numbers in a vector, as in the feature of posture variation.
pub const WIDTH: usize = 12;
/// Heaps that the vectors lie in.
const HEAPS: usize = 60;

/// So many vectors, one after the other.
#[must_use]
pub fn heaped(count: usize) -> Vec<f64> {
    let mut draw = Draw(5);
    let heaps: Vec<([f64; WIDTH], f64)> = (0..HEAPS)
        .map(|_| {
            (
                [(); WIDTH].map(|()| 0.05 * draw.share()),
                0.012 * draw.share(),
            )
        })
        .collect();
    let mut values = Vec::with_capacity(count * WIDTH);
    for _ in 0..count {
        let (middle, width) = heaps[(draw.share() * HEAPS as f64) as usize];
        values.extend(middle.map(|at| at + width * draw.bell()));
    }
    values
}

/// SplitMix64 (Steele, Lea and Flood 2014).
struct Draw(u64);

impl Draw {
    /// From 0 up to 1.
    fn share(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((mixed ^ (mixed >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Around 0, nearly normal, of variance 1.
    fn bell(&mut self) -> f64 {
        (0..12).map(|_| self.share()).sum::<f64>() - 6.0
    }
}
