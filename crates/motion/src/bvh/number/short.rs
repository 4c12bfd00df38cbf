//! Numbers of at most 15 bytes, nearly all there are: the place of a word goes in, its `f64` comes
//! out, without a loop and without a branch that depends on the digits.
//!
//! The bytes up to the end of the word are taken as one or two integers, so that the last digit
//! always lies in the highest byte. The digits before the point move one byte towards it: what is
//! then summed is ten times the digits, which one exact division makes the number.

/// Bytes of the longest word, without sign: ten times its digits are exact in an `f64`.
const LONGEST: usize = 15;

/// Bytes in one integer.
const WORD: usize = 8;

/// One in each byte.
const ONES: u64 = u64::from_le_bytes([1; WORD]);

/// The highest bit of each byte.
const TOPS: u64 = ONES << 7;

/// The digit zero in each byte.
const ZEROS: u64 = u64::from_le_bytes([b'0'; WORD]);

/// The point in each byte, as it is beside digits.
const POINTS: u64 = u64::from_le_bytes([b'.' ^ b'0'; WORD]);

/// What the digits are divided by, for each byte that the point may be in; the ninth is for a
/// word without one. First for the late bytes, then for the early ones.
const DIVISORS: [[f64; WORD + 1]; 2] = [
    [1e8, 1e7, 1e6, 1e5, 1e4, 1e3, 1e2, 1e1, 1.0],
    [1e16, 1e15, 1e14, 1e13, 1e12, 1e11, 1e10, 1e9, 1.0],
];

/// The number that the word from `start` to `end` is, to the bit; none if the word is longer or of
/// another shape, or ends before the 16th byte.
#[inline]
pub fn number(bytes: &[u8], start: usize, end: usize) -> Option<f64> {
    let window = bytes.get(end.wrapping_sub(2 * WORD)..end)?;
    let (early, late) = window.split_first_chunk::<WORD>()?;
    let late: [u8; WORD] = late.try_into().ok()?;
    let is_negative = bytes.get(start) == Some(&b'-');
    let length = end - start - usize::from(is_negative);
    let (early, late) = (u64::from_le_bytes(*early), u64::from_le_bytes(late));
    let size = match length {
        1..=WORD => near(late, length)?,
        0 => return None,
        9..=LONGEST => far(early, late, length)?,
        _ => return None,
    };
    Some(f64::from_bits(
        size.to_bits() | u64::from(is_negative) << 63,
    ))
}

/// The number in the last `length` bytes, 1 to 8 of them.
#[inline]
fn near(bytes: u64, length: usize) -> Option<f64> {
    let word = last(bytes, length);
    let point = point_in(word);
    let digits = closed_up(word, word >> 8, point);
    let is_number = are_digits(digits) && length > usize::from(point != 0);
    is_number.then(|| value(digits) as f64 / divisor(0, point))
}

/// The number in the last `length` bytes, 9 to 15 of them.
#[inline]
fn far(early: u64, late: u64, length: usize) -> Option<f64> {
    let (early, late) = (last(early, length - WORD), late ^ ZEROS);
    let early_point = point_in(early);
    let early_digits = closed_up(early, early >> 8 | late << 56, early_point);
    let (late_digits, divisor) = match early_point {
        0 => {
            let point = point_in(late);
            (closed_up(late, late >> 8, point), divisor(0, point))
        }
        point => (late >> 8, divisor(1, point)),
    };
    let is_number = are_digits(early_digits) && are_digits(late_digits);
    let digits = value(early_digits) * 100_000_000 + value(late_digits);
    is_number.then(|| digits as f64 / divisor)
}

/// The last `length` bytes, 1 to 8 of them, digits as 0 to 9; the others zero.
#[inline]
fn last(bytes: u64, length: usize) -> u64 {
    (bytes ^ ZEROS) & (u64::MAX << (8 * (WORD - length)))
}

/// The top bit of the first byte that is a point; zero where there is none.
#[inline]
fn point_in(word: u64) -> u64 {
    let differing = word ^ POINTS;
    let points = differing.wrapping_sub(ONES) & !differing & TOPS;
    points & points.wrapping_neg()
}

/// The bytes before a point, and from it on those of `moved`, the ones behind.
#[inline]
fn closed_up(bytes: u64, moved: u64, point: u64) -> u64 {
    let before = (point >> 7).wrapping_sub(1);
    (bytes & before) | (moved & !before)
}

#[inline]
fn are_digits(digits: u64) -> bool {
    const OVER: u64 = (0x7F - 9) * ONES;
    (digits.wrapping_add(OVER) | digits) & TOPS == 0
}

#[inline]
fn divisor(group: usize, point: u64) -> f64 {
    DIVISORS[group][(point.trailing_zeros() >> 3) as usize]
}

/// The value of eight digits, the first in the lowest byte (D. Lemire, *Number parsing at a
/// gigabyte per second*, Software: Practice and Experience 51, 2021): pairs, then all at once.
#[inline]
fn value(digits: u64) -> i64 {
    const FOURTH: u64 = 0x0000_00FF_0000_00FF;
    const FIRST_AND_THIRD: u64 = 100 + (1_000_000 << 32);
    const SECOND_AND_FOURTH: u64 = 1 + (10_000 << 32);
    let pairs = digits.wrapping_mul(10).wrapping_add(digits >> 8);
    let sum = (pairs & FOURTH).wrapping_mul(FIRST_AND_THIRD);
    let sum = sum.wrapping_add((pairs >> 16 & FOURTH).wrapping_mul(SECOND_AND_FOURTH));
    (sum >> 32) as i64
}
