//! Numbers of at most 15 bytes, nearly all there are: two words at a time go in, their numbers come
//! out, without a loop and without a branch.
//!
//! The 16 bytes before the end of a word are taken at once, and made 16 digits, without the point
//! and with zeros before them. Two neighbours are summed, then two pairs, then two fours; the sum of
//! all, below 10¹⁵, is exact, and so is the power of ten that it is divided by.

use super::order::Order;
use wide::bytemuck::cast;
use wide::{f64x2, i16x8, i32x8, u16x8, u64x2};

/// The longest word in bytes and one more.
const LIMIT: usize = 16;

/// Bytes of a block with the 16 before it, which the first word may need.
pub const WINDOW: usize = LIMIT + 64;

/// A word of a block: digits, at least one, with or without a point, after the sign.
#[derive(Clone, Copy, Debug)]
pub struct ShortWord {
    /// Where the word ends in the block.
    pub end: usize,
    /// 16 times its length without sign, plus the place of its point, the length without one.
    pub shape: usize,
    /// The sign bit.
    pub sign: u64,
}

/// What is done with the bytes of a word.
#[derive(Clone, Copy)]
struct Shape {
    order: Order,
    /// One with as many zeros as there are decimals.
    divisor: f64,
}

/// By [`ShortWord::shape`].
static SHAPES: [Shape; LIMIT * LIMIT] = shapes();

const fn shapes() -> [Shape; LIMIT * LIMIT] {
    let mut shapes = [shape(0, 0); LIMIT * LIMIT];
    let mut index = 1;
    while index < LIMIT * LIMIT {
        shapes[index] = shape(index / LIMIT, index % LIMIT);
        index += 1;
    }
    shapes
}

const fn shape(length: usize, point: usize) -> Shape {
    let mut divisor = 1.0;
    let mut decimals = point + 1;
    while decimals < length {
        divisor *= 10.0;
        decimals += 1;
    }
    Shape {
        order: Order::of(length, point),
        divisor,
    }
}

/// The numbers that two words are, to the bit.
#[inline]
pub fn pair(window: &[u8; WINDOW], words: [ShortWord; 2]) -> [f64; 2] {
    let shapes = words.map(|word| &SHAPES[word.shape & (LIMIT * LIMIT - 1)]);
    let fours = [0, 1].map(|index| fours(window, words[index].end & 63, shapes[index]));
    let fours: i32x8 = cast(fours);
    let weights = i16x8::new([10_000, 1, 10_000, 1, 10_000, 1, 10_000, 1]);
    let eights: u64x2 = cast(i16x8::from_i32x8_saturate(fours).dot(weights));
    let early = small(eights & u64x2::splat(u64::from(u32::MAX)));
    let late = small(eights >> 32);
    let digits = early * f64x2::splat(1e8) + late;
    let sizes = digits / f64x2::new(shapes.map(|shape| shape.divisor));
    let bits: u64x2 = cast::<_, u64x2>(sizes) | u64x2::new(words.map(|word| word.sign));
    cast(bits)
}

/// The digits before a place of the block, four by four.
#[inline]
fn fours(window: &[u8; WINDOW], end: usize, shape: &Shape) -> wide::i32x4 {
    let bytes = window[end..].first_chunk().unwrap_or(&[b'0'; LIMIT]);
    let digits = shape.order.of_digits(*bytes);
    // Of two digits the first is in the lower byte: ten times it and the second come into the upper.
    let tens_and_ones = cast::<_, u16x8>(digits) * u16x8::splat(10 << 8 | 1);
    let pairs = tens_and_ones >> 8;
    cast::<_, i16x8>(pairs).dot(i16x8::new([100, 1, 100, 1, 100, 1, 100, 1]))
}

/// Numbers below 2³² as `f64`: with the bits of 2⁵² they are the lowest bits of one.
#[inline]
fn small(numbers: u64x2) -> f64x2 {
    const OFFSET: f64 = (1_u64 << 52) as f64;
    cast::<_, f64x2>(numbers | u64x2::splat(OFFSET.to_bits())) - f64x2::splat(OFFSET)
}
