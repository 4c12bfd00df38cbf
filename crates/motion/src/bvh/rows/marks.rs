//! The bytes of a block go in; what each of them is comes out as bits, the first byte in the lowest.

use wide::bytemuck::cast;
use wide::u8x16;

/// Bytes of a block.
pub const BLOCK: usize = 64;

/// Bytes that are compared at once.
const AT_ONCE: usize = 16;

/// One bit for each byte of a block.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Marks {
    /// White space and control characters, see [`crate::bvh::place::is_blank`].
    pub blanks: u64,
    /// Line feeds, carriage returns and the two characters between them.
    pub line_ends: u64,
    /// `0` to `9`.
    pub digits: u64,
    /// `.`
    pub points: u64,
    /// `-`
    pub minuses: u64,
}

impl Marks {
    /// Of 64 bytes.
    #[inline]
    pub fn of(block: &[u8; BLOCK]) -> Self {
        let mut marks = Self::default();
        for (index, bytes) in block.as_chunks::<AT_ONCE>().0.iter().enumerate() {
            let bytes: u8x16 = cast(*bytes);
            let bits = |is: u8x16| u64::from(is.to_bitmask()) << (AT_ONCE * index);
            let from = |first: u8| bytes - u8x16::splat(first);
            marks.blanks |= bits(bytes.simd_le(u8x16::splat(b' ')));
            marks.line_ends |= bits(from(b'\n').simd_lt(u8x16::splat(4)));
            marks.digits |= bits(from(b'0').simd_lt(u8x16::splat(10)));
            marks.points |= bits(bytes.simd_eq(u8x16::splat(b'.')));
            marks.minuses |= bits(bytes.simd_eq(u8x16::splat(b'-')));
        }
        marks
    }
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
                    digits: bits(|byte| byte.is_ascii_digit()),
                    points: bits(|byte| byte == b'.'),
                    minuses: bits(|byte| byte == b'-'),
                };
                assert_eq!(Marks::of(&block), expected);
            }
        }
    }
}
