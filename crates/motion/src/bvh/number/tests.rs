//! Numbers of every shape against `str::parse`, to the bit.

use super::*;
use test_support::Random;

/// Reads the whole of `text` as a row does.
fn read(text: &str) -> Word {
    match plain(text.as_bytes(), 0, Some(Mark::Point)) {
        Some((number, end)) if end == text.len() => Word::Number(number),
        _ => odd_word(text.as_bytes()),
    }
}

fn check(text: &str) {
    let expected: f64 = text.parse().expect("a number");
    let expected = match expected.is_finite() {
        true => Word::Number(expected),
        false => Word::NotANumber,
    };
    let read = read(text);
    assert_eq!(read, expected, "{text}");
    if let (Word::Number(read), Word::Number(expected)) = (read, expected) {
        assert_eq!(read.to_bits(), expected.to_bits(), "{text}");
    }
}

/// The word and what is read of it, by whichever way takes it, must be the same.
fn check_ways(text: &str) {
    let bits = |number: f64| number.to_bits();
    let known = match odd_word(text.as_bytes()) {
        Word::Number(number) => Some(bits(number)),
        _ => None,
    };
    for mark in [None, Some(Mark::Point), Some(Mark::Comma)] {
        match plain(text.as_bytes(), 0, mark) {
            Some((number, end)) if end == text.len() => {
                assert_eq!(Some(bits(number)), known, "{text} with {mark:?}");
            }
            _ => {}
        }
    }
}

fn digits_of(random: &mut Random, count: usize) -> String {
    let digit = |_| char::from(b'0' + random.below(10) as u8);
    (0..count).map(digit).collect()
}

/// A number below one of the limits.
fn below_one_of(random: &mut Random, limits: &[usize]) -> usize {
    let limit = limits[random.below(limits.len())];
    random.below(limit)
}

/// Sign, whole digits, decimals and exponent, each of any length; often zeros.
fn any_shape(random: &mut Random) -> String {
    let sign = ["", "", "-", "+"][random.below(4)];
    let whole_length = below_one_of(random, &[3, 8, 25]);
    let mut text = [sign, &digits_of(random, whole_length)].concat();
    if random.below(4) > 0 {
        text.push('.');
        text += &"0".repeat(below_one_of(random, &[1, 1, 30]));
        let decimals = below_one_of(random, &[4, 9, 20, 40]);
        text += &digits_of(random, decimals);
    }
    if !text.contains(|c: char| c.is_ascii_digit()) {
        text.push('7');
    }
    if random.below(4) == 0 {
        text.push(['e', 'E'][random.below(2)]);
        text += ["", "-", "+"][random.below(3)];
        text += &below_one_of(random, &[10, 25, 340]).to_string();
    }
    text
}

/// As programs print numbers: fixed, shortest and in the halves between two numbers.
fn printed(random: &mut Random) -> String {
    let bits = f64::from_bits(random.next());
    let number = if bits.is_finite() {
        bits
    } else {
        random.unit()
    };
    let usual = (random.unit() - 0.5) * [1.0, 360.0, 1e4][random.below(3)];
    match random.below(6) {
        0 => format!("{number:e}"),
        1 => format!("{number:.17e}"),
        2 => format!("{usual}"),
        3 => format!("{usual:.6}"),
        4 => format!("{usual:.*}", random.below(25)),
        _ => {
            let odd = (random.next() >> 11) | (1 << 52);
            format!("{odd}.5")
        }
    }
}

#[test]
fn a_million_numbers_of_every_shape_are_exact() {
    let mut random = Random::new(20);
    for _ in 0..500_000 {
        check(&any_shape(&mut random));
        check(&printed(&mut random));
    }
}

#[test]
fn all_ways_read_the_same_words() {
    let characters = b"0123456789012345678901234567890..,--+eE/:x";
    let mut random = Random::new(21);
    for _ in 0..500_000 {
        let length = below_one_of(&mut random, &[4, 10, 20]);
        let byte = |_| char::from(characters[random.below(characters.len())]);
        check_ways(&(0..length).map(byte).collect::<String>());
        check_ways(&any_shape(&mut random));
    }
}

#[test]
fn numbers_at_the_edges_are_exact() {
    for text in [
        "0",
        "-0",
        "-0.000000",
        "9007199254740992",
        "9007199254740993",
        "9007199254740993e22",
        "9007199254740992e22",
        "9007199254740991e-22",
        "9007199254740992e23",
        "1e22",
        "1e23",
        "123456789012345678e0",
        "9999999999999999999",
        "18446744073709551616",
        "1e-22",
        "1e-23",
        "0.0000000000000000000000001",
        "5e-324",
        "2.4703282292062327e-324",
        "1.7976931348623157e308",
        "1e309",
        "1e-400",
        "1e99999",
        "1e0001",
        "00000000000000000000001.5",
        "1.",
        ".5",
        "-.5",
        "+3",
        "2.2250738585072011e-308",
        "179769313486231580793e289",
    ] {
        check(text);
    }
}

#[test]
fn ordinary_numbers_take_the_plain_way() {
    let mut random = Random::new(3);
    for _ in 0..10_000 {
        let usual = (random.unit() - 0.5) * 1000.0;
        for text in [
            format!("{usual:.4}"),
            format!("{usual:.6}"),
            format!("{usual:.6e}"),
        ] {
            assert!(
                plain(text.as_bytes(), 0, Some(Mark::Point)).is_some(),
                "{text}"
            );
        }
    }
}

#[test]
fn a_number_ends_where_it_ends() {
    assert_eq!(plain(b"x-1.5 2", 1, Some(Mark::Point)), Some((-1.5, 5)));
    assert_eq!(plain(b"1e5x", 0, None), Some((1e5, 3)));
    assert_eq!(plain(b"1.5", 0, None), Some((1.0, 1)));
    assert_eq!(plain(b"1.5", 0, Some(Mark::Comma)), Some((1.0, 1)));
    assert_eq!(plain(b"1. ", 0, Some(Mark::Point)), Some((1.0, 2)));
    assert_eq!(plain(b"1, ", 0, Some(Mark::Comma)), None);
    assert_eq!(plain(b"-1,25 ", 0, Some(Mark::Comma)), Some((-1.25, 5)));
    for text in ["", "-", ".", "-.", "e5", "1e", "1e+", "nan", "+1"] {
        assert_eq!(plain(text.as_bytes(), 0, Some(Mark::Point)), None, "{text}");
    }
}

#[test]
fn words_that_are_no_numbers_are_known() {
    for text in [
        "NaN",
        "-nan",
        "nan(ind)",
        "-nan(ind)",
        "inf",
        "-Infinity",
        "1.#QNAN",
        "1.#INF",
        "-1.#IND",
        "-1.#IND00",
        "1.#INF00",
        "1.#SNAN",
        "1e400",
    ] {
        assert_eq!(word(text.as_bytes()), Word::NotANumber, "{text}");
    }
    for text in [
        "", "-", "x", "1,", ",", "1,2,3", "1,2.3", "1_0", "0x10", "1.#X", "ünd",
    ] {
        assert_eq!(word(text.as_bytes()), Word::Text, "{text}");
    }
    assert_eq!(word(b"-1,25e1"), Word::Number(-12.5));
}

#[test]
fn a_cut_number_is_known() {
    for text in ["-", "1e", "1.5e-", "+", ".", "n", "-na", "nan(i", "in"] {
        assert!(is_cut(text.as_bytes()), "{text}");
    }
    for text in ["x", "--", "1.5x", "nano"] {
        assert!(!is_cut(text.as_bytes()), "{text}");
    }
}
