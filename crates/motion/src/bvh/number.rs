//! Numbers: bytes of a row go in, the `f64` that `str::parse` makes of them comes out.

/// Powers of ten that an `f64` holds exactly.
const EXACT_POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];

/// Reads the number at `start` up to the first byte that does not belong to it, if it is of a
/// plain shape: at most 19 digits, an exponent of at most 22 and a significand that an `f64`
/// holds exactly. Then one multiplication or division by an exact power of ten rounds right
/// (Clinger, *How to read floating point numbers accurately*, 1990, §3).
#[inline]
pub fn plain(bytes: &[u8], start: usize) -> Option<(f64, usize)> {
    let mut at = start;
    let is_negative = bytes.get(at) == Some(&b'-');
    at += usize::from(is_negative);
    let (mut significand, whole_end) = digits(bytes, at, 0);
    let mut count = whole_end - at;
    at = whole_end;
    let mut exponent = 0_i32;
    if bytes.get(at) == Some(&b'.') {
        let (all, end) = digits(bytes, at + 1, significand);
        let decimals = end - (at + 1);
        significand = all;
        count += decimals;
        exponent = -(decimals as i32);
        at = end;
    }
    if let Some(b'e' | b'E') = bytes.get(at) {
        let (power, end) = exponent_part(bytes, at + 1)?;
        exponent += power;
        at = end;
    }
    let is_plain = (1..=19).contains(&count) && significand <= 1 << 53;
    if !is_plain || !(-22..=22).contains(&exponent) {
        return None;
    }
    let power = EXACT_POWERS[exponent.unsigned_abs() as usize];
    let size = match exponent < 0 {
        true => significand as f64 / power,
        false => significand as f64 * power,
    };
    Some((if is_negative { -size } else { size }, at))
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

fn exponent_part(bytes: &[u8], start: usize) -> Option<(i32, usize)> {
    let sign = bytes.get(start)?;
    let first = start + usize::from(matches!(sign, b'+' | b'-'));
    let (size, end) = digits(bytes, first, 0);
    let is_plain = (1..=3).contains(&(end - first));
    let size = if *sign == b'-' {
        -(size as i32)
    } else {
        size as i32
    };
    is_plain.then_some((size, end))
}

/// What a word of a row is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Word {
    /// A finite number.
    Number(f64),
    /// What tools write for "not a number" and "infinite".
    NotANumber,
    /// Anything else.
    Text,
}

/// Which mark stands before the decimals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// `1.5`
    Point,
    /// `1,5`
    Comma,
}

/// The decimal mark in a word, if there is one.
pub fn mark(word: &[u8]) -> Option<Mark> {
    word.iter().find_map(|byte| match byte {
        b'.' => Some(Mark::Point),
        b',' => Some(Mark::Comma),
        _ => None,
    })
}

/// Reads a word of any shape; a decimal comma is read as a point.
pub fn word(word: &[u8]) -> Word {
    let Ok(text) = core::str::from_utf8(word) else {
        return Word::Text;
    };
    if is_not_a_number(text) {
        return Word::NotANumber;
    }
    let parsed = match text.split_once(',') {
        Some((_, decimals)) if !decimals.starts_with(|c: char| c.is_ascii_digit()) => None,
        Some(_) => text.replacen(',', ".", 1).parse().ok(),
        None => text.parse().ok(),
    };
    match parsed {
        Some(number) if f64::is_finite(number) => Word::Number(number),
        Some(_) => Word::NotANumber,
        None => Word::Text,
    }
}

/// `nan`, `-nan(ind)`, `inf`, and `1.#QNAN`, `-1.#IND00`, `1.#INF` of older C libraries.
fn is_not_a_number(text: &str) -> bool {
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
    let lower = unsigned.to_ascii_lowercase();
    match lower.strip_prefix("1.#") {
        Some(name) => ["qnan", "snan", "nan", "inf", "ind"]
            .iter()
            .any(|known| name.starts_with(known)),
        None => {
            matches!(lower.as_str(), "nan" | "inf" | "infinity")
                || (lower.starts_with("nan(") && lower.ends_with(')'))
        }
    }
}

/// Whether a word that the end of the file cuts off could have become a number.
pub fn is_cut(word: &[u8]) -> bool {
    let mut whole = word.to_vec();
    whole.push(b'0');
    let begins_a_name = [&b"nan"[..], b"inf", b"-nan", b"-inf"]
        .iter()
        .any(|name| name.starts_with(&word.to_ascii_lowercase()));
    begins_a_name || matches!(self::word(&whole), Word::Number(_))
}
