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
        let (mut no_blanks, mut no_digits) = (0, 0);
        let mut least_from_line_feed = u8x16::splat(u8::MAX);
        for (index, bytes) in block.as_chunks::<AT_ONCE>().0.iter().enumerate() {
            let bytes: u8x16 = cast(*bytes);
            let bits = |is: u8x16| u64::from(is.to_bitmask()) << (AT_ONCE * index);
            no_blanks |= bits(at_least(bytes, b' ' + 1));
            no_digits |= bits(at_least(bytes - u8x16::splat(b'0'), 10));
            marks.points |= bits(bytes.simd_eq(u8x16::splat(b'.')));
            marks.minuses |= bits(bytes.simd_eq(u8x16::splat(b'-')));
            least_from_line_feed = least_from_line_feed.min(bytes - u8x16::splat(b'\n'));
        }
        (marks.blanks, marks.digits) = (!no_blanks, !no_digits);
        if !at_least(least_from_line_feed, 4).all() {
            marks.line_ends = line_ends(block);
        }
        marks
    }
}

#[inline]
fn line_ends(block: &[u8; BLOCK]) -> u64 {
    let chunks = block.as_chunks::<AT_ONCE>().0.iter().rev();
    !chunks.fold(0, |others, bytes| {
        let from_line_feed = cast::<_, u8x16>(*bytes) - u8x16::splat(b'\n');
        others << AT_ONCE | u64::from(at_least(from_line_feed, 4).to_bitmask())
    })
}

/// Sets the highest bit of the bytes that are not below `least`, which is no more than 128; to
/// compare takes more instructions.
#[inline]
fn at_least(bytes: u8x16, least: u8) -> u8x16 {
    bytes.saturating_add(u8x16::splat(128 - least))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bvh::place::is_blank;
    use test_support::Random;

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
