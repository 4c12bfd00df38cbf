//! The bytes of a block go in; which of them are blank and which may end a line come out as bits,
//! the first byte in the lowest.

/// Bytes of a block.
pub const BLOCK: usize = 64;

/// One bit for each byte of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Marks {
    /// White space and control characters, see [`crate::bvh::place::is_blank`].
    pub blanks: u64,
    /// Line feeds, carriage returns and the two characters between them.
    pub line_ends: u64,
}

impl Marks {
    /// Of 64 bytes.
    #[cfg(target_feature = "simd128")]
    #[inline]
    pub fn of(block: &[u8; BLOCK]) -> Self {
        use core::arch::wasm32::{u8x16_bitmask, u8x16_le, u8x16_splat, u8x16_sub};
        let mut marks = Self {
            blanks: 0,
            line_ends: 0,
        };
        for (index, bytes) in block.as_chunks::<16>().0.iter().enumerate() {
            let bytes = vector(bytes);
            let blanks = u8x16_le(bytes, u8x16_splat(b' '));
            let from_line_feed = u8x16_sub(bytes, u8x16_splat(b'\n'));
            let line_ends = u8x16_le(from_line_feed, u8x16_splat(b'\r' - b'\n'));
            marks.blanks |= u64::from(u8x16_bitmask(blanks)) << (16 * index);
            marks.line_ends |= u64::from(u8x16_bitmask(line_ends)) << (16 * index);
        }
        marks
    }

    /// Of 64 bytes.
    #[cfg(not(target_feature = "simd128"))]
    #[inline]
    pub fn of(block: &[u8; BLOCK]) -> Self {
        let mut marks = Self {
            blanks: 0,
            line_ends: 0,
        };
        for (index, bytes) in block.as_chunks::<8>().0.iter().enumerate() {
            let bytes = u64::from_le_bytes(*bytes);
            let line_ends = from(bytes, b'\n') & !from(bytes, b'\r' + 1);
            marks.blanks |= gathered(!from(bytes, b' ' + 1)) << (8 * index);
            marks.line_ends |= gathered(line_ends) << (8 * index);
        }
        marks
    }
}

#[cfg(target_feature = "simd128")]
#[inline]
fn vector(bytes: &[u8; 16]) -> core::arch::wasm32::v128 {
    let (early, late) = bytes.as_chunks::<8>().0.split_at(1);
    core::arch::wasm32::i64x2(i64::from_le_bytes(early[0]), i64::from_le_bytes(late[0]))
}

/// The top bit of each byte that is at least `least`, an ASCII character.
#[cfg(not(target_feature = "simd128"))]
#[inline]
fn from(bytes: u64, least: u8) -> u64 {
    const ONES: u64 = u64::from_le_bytes([1; 8]);
    ((bytes & (0x7F * ONES)) + u64::from(0x80 - least) * ONES) | bytes
}

/// The top bits of all bytes, as eight bits.
#[cfg(not(target_feature = "simd128"))]
#[inline]
fn gathered(tops: u64) -> u64 {
    const TOPS: u64 = u64::from_le_bytes([0x80; 8]);
    const TO_THE_TOP: u64 = 0x0102_0408_1020_4080;
    ((tops & TOPS) >> 7).wrapping_mul(TO_THE_TOP) >> 56
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bvh::place::is_blank;
    use crate::test_random::Random;

    #[test]
    fn every_byte_at_every_place_is_marked() {
        let mut random = Random::new(5);
        for byte in 0..=u8::MAX {
            for place in 0..BLOCK {
                let mut block: [u8; BLOCK] = core::array::from_fn(|_| random.next() as u8);
                block[place] = byte;
                let bits = |is: fn(u8) -> bool| {
                    let bytes = block.iter().enumerate();
                    bytes.fold(0, |bits, (at, byte)| bits | u64::from(is(*byte)) << at)
                };
                let expected = Marks {
                    blanks: bits(is_blank),
                    line_ends: bits(|byte| (b'\n'..=b'\r').contains(&byte)),
                };
                assert_eq!(Marks::of(&block), expected);
            }
        }
    }
}
