//! Numbers of at most 8 digits, their sign included, with as many decimals as their neighbours: four
//! words at a time go in, their numbers come out, without a loop and without a branch.
//!
//! Most files are written with one format for all numbers, so that the point of every word stands as
//! far from its end. Then the digits of two words fit one vector, those of four are summed together,
//! and all are divided by the same power of ten. The sums, below 10⁸, are exact, and so is the power.

use super::short::WINDOW;
use wide::bytemuck::cast;
use wide::{f64x2, i16x8, i32x8, u8x16, u16x8, u64x2};

/// Bytes of a block, and of those before it that its first word may need.
const BLOCK: usize = 64;
const BEFORE: usize = WINDOW - BLOCK;

/// Most bytes of a word without its point.
pub const MOST_BYTES: usize = 8;

/// Decimals that all words may have: one at least, and one byte before the point may be a digit.
pub const MOST_DECIMALS: usize = 7;

/// Bytes of a text of eight that belong to a word, by the bytes that it has with its point.
const LAST: [u64; BLOCK] = last();

const fn last() -> [u64; BLOCK] {
    let mut last = [u64::MAX; BLOCK];
    let mut count = 0;
    while count < MOST_BYTES {
        last[count + 1] = last_bytes(count);
        count += 1;
    }
    last
}

const fn last_bytes(count: usize) -> u64 {
    !(u64::MAX >> (8 * count))
}

/// A word of a block: digits with a point between or before them, after the sign.
#[derive(Clone, Copy, Debug)]
pub struct EvenWord {
    /// Where the word ends in the block.
    pub end: usize,
    /// Its bytes, with its point and the blanks before it.
    pub length: usize,
}

/// How words with a number of decimals are read.
#[derive(Clone, Copy, Debug)]
pub struct Even {
    /// Of the eight bytes without point, those of the decimals.
    decimals: u64,
    /// Minus one with as many zeros as there are decimals.
    divisor: f64,
}

impl Even {
    /// For words with so many decimals, from 1 to [`MOST_DECIMALS`].
    pub fn of(decimals: usize) -> Self {
        const POWERS: [f64; MOST_BYTES] = [1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7];
        let decimals = decimals % MOST_BYTES;
        Self {
            decimals: last_bytes(decimals),
            divisor: -POWERS[decimals],
        }
    }

    /// The numbers that four words are, to the bit.
    #[inline(always)]
    pub fn four(self, window: &[u8; WINDOW], [a, b, c, d]: [EvenWord; 4]) -> [f64; 4] {
        let text = |word| self.text(window, word);
        let texts = [
            u64x2::new([text(a), text(b)]),
            u64x2::new([text(c), text(d)]),
        ];
        let fours = [fours(texts[0]), fours(texts[1])];
        let weights = i16x8::new([10_000, 1, 10_000, 1, 10_000, 1, 10_000, 1]);
        let digits = i16x8::from_i32x8_saturate(cast::<_, i32x8>(fours)).dot(weights);
        let late: u64x2 = cast(digits);
        let late = u64x2::new([late.to_array()[1], 0]);
        let sizes = [
            f64x2::from_i32x4_lower2(digits),
            f64x2::from_i32x4_lower2(cast(late)),
        ];
        let divisor = f64x2::splat(self.divisor);
        cast([
            signed(sizes[0] / divisor, texts[0]),
            signed(sizes[1] / divisor, texts[1]),
        ])
    }

    /// The bytes of a word without its point, zero bytes before them.
    #[inline(always)]
    fn text(self, window: &[u8; WINDOW], word: EvenWord) -> u64 {
        let bytes = |start: usize| match window[start..].first_chunk() {
            Some(bytes) => u64::from_le_bytes(*bytes),
            None => 0,
        };
        let end = BEFORE + word.end;
        let (decimals, whole) = (bytes(end - 8), bytes(end - 9));
        let text = (decimals & self.decimals) | (whole & !self.decimals);
        text & LAST[word.length % BLOCK]
    }
}

/// The digits of two texts, four by four.
#[inline]
fn fours(texts: u64x2) -> wide::i32x4 {
    let digits = cast::<_, u8x16>(texts).saturating_sub(u8x16::splat(b'0'));
    // Of two digits the first is in the lower byte: ten times it and the second come into the upper.
    let tens_and_ones = cast::<_, u16x8>(digits) * u16x8::splat(10 << 8 | 1);
    let pairs = tens_and_ones >> 8;
    cast::<_, i16x8>(pairs).dot(i16x8::new([100, 1, 100, 1, 100, 1, 100, 1]))
}

/// Numbers with the signs of their texts, given with a minus, zero too.
#[inline]
fn signed(negative: f64x2, texts: u64x2) -> f64x2 {
    let minuses: u64x2 = cast(cast::<_, u8x16>(texts).simd_eq(u8x16::splat(b'-')));
    let is_positive = minuses.simd_eq(u64x2::splat(0));
    cast(cast::<_, u64x2>(negative) ^ (is_positive << 63))
}
