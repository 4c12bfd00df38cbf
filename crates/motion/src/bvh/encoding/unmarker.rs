//! Byte order marks: slices go in, the same bytes without mark go out, UTF-16 as UTF-8.

use std::borrow::Cow;

/// Takes off a byte order mark and turns UTF-16, which needs one, into UTF-8.
#[derive(Debug, Default)]
pub struct Unmarker {
    state: State,
}

#[derive(Debug)]
enum State {
    /// Fewer than the three bytes of the longest mark are there.
    Start(Vec<u8>),
    AsIs,
    Utf16(Utf16),
}

impl Default for State {
    fn default() -> Self {
        State::Start(Vec::new())
    }
}

impl Unmarker {
    /// Whether the file is UTF-16.
    pub fn is_utf16(&self) -> bool {
        matches!(self.state, State::Utf16(_))
    }

    /// The bytes of the next slice without mark.
    pub fn push<'a>(&mut self, slice: &'a [u8]) -> Cow<'a, [u8]> {
        match &mut self.state {
            State::AsIs => Cow::Borrowed(slice),
            State::Utf16(utf16) => Cow::Owned(utf16.push(slice)),
            State::Start(held) if held.len() + slice.len() < 3 => {
                held.extend_from_slice(slice);
                Cow::Borrowed(&[])
            }
            State::Start(held) if held.is_empty() => self.begin(slice),
            State::Start(held) => {
                held.extend_from_slice(slice);
                let held = core::mem::take(held);
                Cow::Owned(self.begin(&held).into_owned())
            }
        }
    }

    /// What is left at the end of the file.
    pub fn finish(&mut self) -> Vec<u8> {
        match &mut self.state {
            State::Start(held) => {
                let held = core::mem::take(held);
                self.begin(&held).into_owned()
            }
            State::AsIs => Vec::new(),
            State::Utf16(utf16) => utf16.finish(),
        }
    }

    fn begin<'a>(&mut self, bytes: &'a [u8]) -> Cow<'a, [u8]> {
        let is_big_endian = bytes.starts_with(b"\xFE\xFF");
        if is_big_endian || bytes.starts_with(b"\xFF\xFE") {
            let mut utf16 = Utf16 {
                is_big_endian,
                half_unit: None,
                high_surrogate: None,
            };
            let text = utf16.push(&bytes[2..]);
            self.state = State::Utf16(utf16);
            return Cow::Owned(text);
        }
        self.state = State::AsIs;
        Cow::Borrowed(bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes))
    }
}

/// UTF-16 cut anywhere.
#[derive(Debug)]
struct Utf16 {
    is_big_endian: bool,
    half_unit: Option<u8>,
    high_surrogate: Option<u16>,
}

impl Utf16 {
    fn push(&mut self, slice: &[u8]) -> Vec<u8> {
        let mut text = Vec::with_capacity(slice.len());
        for &byte in slice {
            match self.half_unit.take() {
                None => self.half_unit = Some(byte),
                Some(first) if self.is_big_endian => {
                    self.unit(u16::from_be_bytes([first, byte]), &mut text);
                }
                Some(first) => self.unit(u16::from_le_bytes([first, byte]), &mut text),
            }
        }
        text
    }

    fn unit(&mut self, unit: u16, text: &mut Vec<u8>) {
        let is_high = (0xD800..0xDC00).contains(&unit);
        let is_low = (0xDC00..0xE000).contains(&unit);
        let before = self.high_surrogate.take_if(|_| !is_low);
        write(before.as_slice(), text);
        match self.high_surrogate.take() {
            Some(high) => write(&[high, unit], text),
            None if is_high => self.high_surrogate = Some(unit),
            None => write(&[unit], text),
        }
    }

    /// A half unit or half a pair at the end of the file.
    fn finish(&mut self) -> Vec<u8> {
        let is_cut = self.half_unit.take().is_some() | self.high_surrogate.take().is_some();
        match is_cut {
            true => "\u{FFFD}".into(),
            false => Vec::new(),
        }
    }
}

fn write(units: &[u16], text: &mut Vec<u8>) {
    let characters = char::decode_utf16(units.iter().copied());
    for character in characters.map(|unit| unit.unwrap_or(char::REPLACEMENT_CHARACTER)) {
        text.extend_from_slice(character.encode_utf8(&mut [0; 4]).as_bytes());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unmarked(slices: &[&[u8]]) -> Vec<u8> {
        let mut unmarker = Unmarker::default();
        let mut bytes: Vec<u8> = Vec::new();
        for slice in slices {
            bytes.extend_from_slice(&unmarker.push(slice));
        }
        bytes.extend(unmarker.finish());
        bytes
    }

    fn byte_by_byte(bytes: &[u8]) -> Vec<u8> {
        unmarked(&bytes.chunks(1).collect::<Vec<_>>())
    }

    #[test]
    fn a_mark_of_utf8_is_taken_off_once() {
        let bytes = b"\xEF\xBB\xBFa\xEF\xBB\xBF";
        assert_eq!(unmarked(&[bytes]), b"a\xEF\xBB\xBF");
        assert_eq!(byte_by_byte(bytes), b"a\xEF\xBB\xBF");
        assert_eq!(byte_by_byte(b"ab"), b"ab");
    }

    #[test]
    fn utf16_of_both_orders_cut_anywhere_becomes_utf8() {
        let text = "a左🦴\n";
        let units: Vec<u16> = "\u{FEFF}"
            .encode_utf16()
            .chain(text.encode_utf16())
            .collect();
        let little: Vec<u8> = units.iter().flat_map(|unit| unit.to_le_bytes()).collect();
        let big: Vec<u8> = units.iter().flat_map(|unit| unit.to_be_bytes()).collect();
        for bytes in [little, big] {
            assert_eq!(unmarked(&[&bytes]), text.as_bytes());
            assert_eq!(byte_by_byte(&bytes), text.as_bytes());
        }
    }

    #[test]
    fn halves_of_utf16_are_replaced() {
        assert_eq!(byte_by_byte(b"\xFF\xFEa"), "\u{FFFD}".as_bytes());
        assert_eq!(byte_by_byte(b"\xFF\xFE\x00\xD8a\0"), "\u{FFFD}a".as_bytes());
    }
}
