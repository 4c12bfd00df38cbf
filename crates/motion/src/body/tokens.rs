//! A joint's name goes in, its tokens come out: lower-case words and numbers, and the side.

use super::names;
use super::role::Side;

/// One word of a name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Token {
    /// In lower case; letters only.
    pub text: String,
    /// Whether a digit follows without a separator (`L5` is a vertebra, no side).
    pub before_digit: bool,
}

/// The words and numbers of a name, each in the order of the name.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tokens {
    /// The words.
    pub words: Vec<Token>,
    /// The numbers between them (at most 999 999 each), each after how many words.
    pub numbers: Vec<(usize, u32)>,
}

impl Tokens {
    /// Takes the first word off, and the number that is part of it (`Bip01`).
    pub fn drop_first(&mut self) {
        if !self.words.is_empty() {
            self.words.remove(0);
            self.numbers.retain(|(words, _)| *words > 1);
            self.numbers.iter_mut().for_each(|(words, _)| *words -= 1);
        }
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Class {
    Lower,
    Upper,
    Digit,
    Separator,
    Script,
}

fn class(letter: char) -> Class {
    match letter {
        '0'..='9' => Class::Digit,
        'a'..='z' => Class::Lower,
        'A'..='Z' => Class::Upper,
        _ if letter.is_lowercase() => Class::Lower,
        _ if letter.is_uppercase() => Class::Upper,
        _ if letter.is_alphabetic() || letter == 'ー' => Class::Script,
        _ => Class::Separator,
    }
}

/// Full-width digits and letters as the usual ones.
fn narrow(letter: char) -> char {
    match u32::from(letter) {
        wide @ 0xFF01..=0xFF5E => char::from_u32(wide - 0xFEE0).unwrap_or(letter),
        _ => letter,
    }
}

/// The name without a namespace: what follows the last `:` or `|`.
fn without_namespace(name: &str) -> &str {
    let own = name.rsplit([':', '|']).next().unwrap_or(name);
    if own.trim().is_empty() { name } else { own }
}

/// Splits at separators, digits, changes of script and the humps of camel case.
pub fn split(name: &str) -> Tokens {
    let letters: Vec<char> = without_namespace(name).chars().map(narrow).collect();
    let mut tokens = Tokens::default();
    let mut start = 0;
    while start < letters.len() {
        let end = run_end(&letters, start);
        let run = &letters[start..end];
        match class(letters[start]) {
            Class::Separator => {}
            Class::Digit => tokens.numbers.push((tokens.words.len(), number(run))),
            _ => tokens.words.extend(side_and_rest(
                &run.iter().collect::<String>().to_lowercase(),
                letters.get(end).is_some_and(char::is_ascii_digit),
            )),
        }
        start = end;
    }
    tokens
}

/// The end of the token that starts at `start`: `Left|Up|Leg`, `L|Hip`, `IK|Foot`, `足|IK`.
fn run_end(letters: &[char], start: usize) -> usize {
    let first = class(letters[start]);
    let mut end = start + 1;
    let mut kind = first;
    while end < letters.len() {
        let next = class(letters[end]);
        let hump = kind == Class::Upper && next == Class::Lower;
        if next != kind && !hump {
            break;
        }
        if hump && end - start > 1 {
            return end - 1;
        }
        kind = next;
        end += 1;
    }
    end
}

fn number(digits: &[char]) -> u32 {
    let value = |sum: u32, digit: &char| (sum * 10 + digit.to_digit(10).unwrap_or(0)).min(999_999);
    digits.iter().fold(0, value)
}

/// 左 and 右 stand without a separator before or after their word.
fn side_and_rest(text: &str, before_digit: bool) -> Vec<Token> {
    let token = |text: &str, before_digit| Token {
        text: text.to_owned(),
        before_digit,
    };
    for side in ["左", "右"] {
        if let Some(rest) = text.strip_prefix(side).filter(|rest| !rest.is_empty()) {
            return vec![token(side, false), token(rest, before_digit)];
        }
        if let Some(rest) = text.strip_suffix(side).filter(|rest| !rest.is_empty()) {
            return vec![token(rest, false), token(side, before_digit)];
        }
    }
    vec![token(text, before_digit)]
}

/// The side that a token is.
fn side_of(token: &Token) -> Option<Side> {
    if token.before_digit && token.text.chars().count() == 1 && token.text.is_ascii() {
        return None;
    }
    side_word(&token.text)
}

fn side_word(text: &str) -> Option<Side> {
    match () {
        () if names::LEFT.contains(&text) => Some(Side::Left),
        () if names::RIGHT.contains(&text) => Some(Side::Right),
        () => None,
    }
}

/// Takes the side out of `words`: the first or the last of them, one glued to a known part
/// (`lhumerus`, `LUArm`, `leftfoot`), or one in the middle.
pub fn take_side(words: &mut Vec<Token>) -> Option<Side> {
    let last = words.len().checked_sub(1)?;
    for place in [0, last] {
        if let Some(side) = side_of(&words[place]) {
            words.remove(place);
            return Some(side);
        }
    }
    if let Some(side) = take_glued(words) {
        return Some(side);
    }
    let middle = words.iter().position(|word| side_of(word).is_some())?;
    side_of(&words.remove(middle))
}

fn take_glued(words: &mut Vec<Token>) -> Option<Side> {
    let all: String = words.iter().map(|word| word.text.as_str()).collect();
    if names::is_known(&all) {
        return None;
    }
    if let Some((side, rest)) = unglue(&all) {
        *words = vec![Token {
            text: rest,
            before_digit: false,
        }];
        return Some(side);
    }
    let place = words
        .iter()
        .position(|word| !names::is_known(&word.text) && unglue(&word.text).is_some())?;
    let (side, rest) = unglue(&words[place].text)?;
    words[place].text = rest;
    Some(side)
}

fn unglue(text: &str) -> Option<(Side, String)> {
    for word in names::LEFT.iter().chain(names::RIGHT) {
        let rest = [text.strip_prefix(word), text.strip_suffix(word)];
        let paired = rest
            .into_iter()
            .flatten()
            .find(|rest| names::is_paired(rest));
        if let Some(rest) = paired {
            return side_word(word).map(|side| (side, rest.to_owned()));
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(name: &str) -> Vec<String> {
        split(name)
            .words
            .into_iter()
            .map(|word| word.text)
            .collect()
    }

    fn side(name: &str) -> Option<(Side, String)> {
        let mut words = split(name).words;
        let side = take_side(&mut words)?;
        Some((side, words.into_iter().map(|word| word.text).collect()))
    }

    #[test]
    fn names_split_at_humps_digits_and_separators() {
        assert_eq!(words("mixamorig:LeftUpLeg"), ["left", "up", "leg"]);
        assert_eq!(words("LHipJoint"), ["l", "hip", "joint"]);
        assert_eq!(words("J_Bip_L_UpperArm"), ["j", "bip", "l", "upper", "arm"]);
        assert_eq!(words("Bip01 L Thigh"), ["bip", "l", "thigh"]);
        assert_eq!(words("左足ＩＫ"), ["左", "足", "ik"]);
        assert_eq!(words("SHOULDER_LEFT"), ["shoulder", "left"]);
        assert_eq!(split("finger3-1.l").numbers, [(1, 3), (1, 1)]);
        assert_eq!(split("左中指３").numbers, [(2, 3)]);
    }

    #[test]
    fn the_side_is_found_wherever_it_stands() {
        let left = |word: &str| Some((Side::Left, word.to_owned()));
        assert_eq!(side("LeftArm"), left("arm"));
        assert_eq!(side("lhumerus"), left("humerus"));
        assert_eq!(side("LUArm"), left("uarm"));
        assert_eq!(side("LFArm"), left("farm"));
        assert_eq!(side("ShoulderLeft"), left("shoulder"));
        assert_eq!(side("upperleg01.L"), left("upperleg"));
        assert_eq!(side("mHandMiddle1Left"), left("mhandmiddle"));
        assert_eq!(side("左ひざ"), left("ひざ"));
        assert_eq!(side("leftfoot"), left("foot"));
        assert_eq!(side("handleft"), left("hand"));
        assert_eq!(side("CC_Base_L_Thigh"), left("ccbasethigh"));
    }

    #[test]
    fn what_has_no_side_gets_none() {
        for name in [
            "L5",
            "T1",
            "lowerback",
            "root",
            "Hips",
            "loarm",
            "Rib",
            "elbow",
            "lumbar",
            "頭",
        ] {
            assert_eq!(side(name), None, "{name}");
        }
    }
}
