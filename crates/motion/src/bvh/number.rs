//! Numbers: bytes of a row go in, the `f64` that `str::parse` makes of them comes out.

mod even;
mod order;
mod short;
mod wide;

pub use even::{Even, EvenWord, MOST_DECIMALS as MOST_EVEN_DECIMALS};
pub use short::{ShortWord, WINDOW, pair as short_pair};

use super::error::{ErrorKind, ParseError, excerpt};
use super::place::Place;

/// Powers of ten that an `f64` holds exactly.
const EXACT_POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];

/// Digits that fit a `u64` whatever they are.
const MOST_DIGITS: usize = 19;

/// Significands up to here are exact in an `f64`.
const MOST_EXACT: u64 = 1 << 53;

/// Reads the number at `start` up to the first byte that does not belong to it, if it is of a
/// plain shape: at most 19 digits, zeros at the beginning aside, and a small exponent. `mark` is
/// the decimal mark to read; without one only whole numbers are plain.
#[inline]
pub fn plain(bytes: &[u8], start: usize, mark: Option<Mark>) -> Option<(f64, usize)> {
    let is_negative = bytes.get(start) == Some(&b'-');
    let first = start + usize::from(is_negative);
    let (whole, mut end) = digits(bytes, first, 0);
    let mut count = end - first;
    let mut significand = whole;
    let mut exponent = 0;
    if mark.is_some_and(|mark| bytes.get(end) == Some(&(mark as u8))) {
        let decimals = end + 1;
        (significand, end) = digits(bytes, decimals, whole);
        if end == decimals && mark == Some(Mark::Comma) {
            return None;
        }
        count += end - decimals;
        exponent = -((end - decimals) as i64);
    }
    if count == 0 || (count > MOST_DIGITS && is_long(&bytes[first..end])) {
        return None;
    }
    if let Some(b'e' | b'E') = bytes.get(end) {
        let (power, after) = power(bytes, end + 1)?;
        exponent += power;
        end = after;
    }
    let size = scaled(significand, exponent)?;
    Some((if is_negative { -size } else { size }, end))
}

/// `significand · 10^exponent`. Where both are exact in an `f64`, one multiplication or division
/// rounds right (Clinger, *How to read floating point numbers accurately*, 1990, §3).
#[inline]
fn scaled(significand: u64, exponent: i64) -> Option<f64> {
    let power = exponent.unsigned_abs() as usize;
    if significand > MOST_EXACT {
        let is_wide = exponent < 0 && power <= wide::MOST_POWER;
        return is_wide.then(|| wide::divided(significand, power));
    }
    let exact = EXACT_POWERS.get(power)?;
    Some(match exponent < 0 {
        true => significand as f64 / exact,
        false => significand as f64 * exact,
    })
}

#[inline]
fn digits(bytes: &[u8], start: usize, before: u64) -> (u64, usize) {
    let mut value = before;
    let mut at = start;
    while let Some(digit) = bytes.get(at).map(|byte| byte.wrapping_sub(b'0')) {
        if digit > 9 {
            break;
        }
        value = value.wrapping_mul(10).wrapping_add(u64::from(digit));
        at += 1;
    }
    (value, at)
}

/// Whether digits with or without a point are too many, zeros at their beginning aside.
fn is_long(digits: &[u8]) -> bool {
    /// Longer numbers are not plain, whatever they hold.
    const LONGEST: usize = 64;
    let zeros = digits
        .iter()
        .take_while(|byte| !matches!(byte, b'1'..=b'9'))
        .count();
    let others = digits[zeros..].iter().filter(|byte| byte.is_ascii_digit());
    digits.len() > LONGEST || others.count() > MOST_DIGITS
}

/// The power of ten after an `e`.
#[inline]
fn power(bytes: &[u8], start: usize) -> Option<(i64, usize)> {
    let sign = *bytes.get(start)?;
    let first = start + usize::from(matches!(sign, b'+' | b'-'));
    let (size, end) = digits(bytes, first, 0);
    // Of more digits the size may have wrapped round.
    let is_short = (1..=4).contains(&(end - first));
    let size = is_short.then_some(size as i64)?;
    Some((if sign == b'-' { -size } else { size }, end))
}

/// What a word of a file is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Word {
    /// A finite number.
    Number(f64),
    /// What tools write for "not a number" and "infinite".
    NotANumber,
    /// Anything else.
    Text,
}

/// Reads a word of any shape; a decimal comma is read as a point.
pub fn word(word: &[u8]) -> Word {
    match plain(word, 0, Some(Mark::Point)) {
        Some((number, end)) if end == word.len() => Word::Number(number),
        _ => odd_word(word),
    }
}

fn odd_word(word: &[u8]) -> Word {
    let Ok(text) = core::str::from_utf8(word) else {
        return Word::Text;
    };
    if is_not_a_number(text) {
        return Word::NotANumber;
    }
    let parsed = match text.split_once(',') {
        None => text.parse(),
        Some((_, decimals)) if decimals.starts_with(|c: char| c.is_ascii_digit()) => {
            text.replacen(',', ".", 1).parse()
        }
        Some(_) => return Word::Text,
    };
    match parsed {
        Ok(number) if f64::is_finite(number) => Word::Number(number),
        Ok(_) => Word::NotANumber,
        Err(_) => Word::Text,
    }
}

/// `nan`, `-nan(ind)`, `inf`, and `1.#QNAN`, `-1.#IND00`, `1.#INF` of older C libraries.
fn is_not_a_number(text: &str) -> bool {
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
    let lower = unsigned.to_ascii_lowercase();
    let Some(name) = lower.strip_prefix("1.#") else {
        let is_named = matches!(lower.as_str(), "nan" | "inf" | "infinity");
        return is_named || (lower.starts_with("nan(") && lower.ends_with(')'));
    };
    let known = ["qnan", "snan", "nan", "inf", "ind"];
    known.iter().any(|known| name.starts_with(known))
}

/// Whether a word that the end of the file cuts off may have been a number.
pub fn is_cut(word: &[u8]) -> bool {
    let lower = word.to_ascii_lowercase();
    let unsigned = lower.strip_prefix(b"-").unwrap_or(&lower);
    let begins_a_name = ["nan(snan)", "nan(ind)", "inf"];
    let begins_a_name = begins_a_name
        .iter()
        .any(|name| name.as_bytes().starts_with(unsigned));
    begins_a_name || matches!(self::word(&[word, b"0"].concat()), Word::Number(_))
}

/// Whether a word begins as a number does.
pub fn looks_like_one(word: &[u8]) -> bool {
    let unsigned = word.strip_prefix(b"-").unwrap_or(word);
    let digits = unsigned.strip_prefix(b".").unwrap_or(unsigned);
    digits.first().is_some_and(u8::is_ascii_digit)
}

/// Which mark stands before the decimals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Mark {
    /// `1.5`
    Point = b'.',
    /// `1,5`
    Comma = b',',
}

/// The decimal mark in a word, if there is one.
pub fn mark(word: &[u8]) -> Option<Mark> {
    word.iter().find_map(|byte| match byte {
        b'.' => Some(Mark::Point),
        b',' => Some(Mark::Comma),
        _ => None,
    })
}

/// The error of a decimal mark that differs from the one used before.
pub fn mixed_marks(word: &str, used: Mark, at: Place) -> ParseError {
    let used = match used {
        Mark::Point => "point",
        Mark::Comma => "comma",
    };
    let details = vec![excerpt(word), used.to_owned()];
    ParseError::new(ErrorKind::MixedDecimalMarks, at, details)
}

#[cfg(test)]
mod tests;
