//! Encodings: slices of a file go in, bytes of which the ASCII part can be read go out; and texts
//! of an unmarked file, once all are there, become strings.

use std::borrow::Cow;

use encoding_rs::{SHIFT_JIS, WINDOWS_1252};

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

#[derive(Debug)]
struct Utf16 {
    big_endian: bool,
    half_unit: Option<u8>,
    high_surrogate: Option<u16>,
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
        let big_endian = bytes.starts_with(b"\xFE\xFF");
        if big_endian || bytes.starts_with(b"\xFF\xFE") {
            let mut utf16 = Utf16 {
                big_endian,
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

impl Utf16 {
    fn push(&mut self, slice: &[u8]) -> Vec<u8> {
        let mut text = Vec::with_capacity(slice.len());
        for &byte in slice {
            match self.half_unit.take() {
                None => self.half_unit = Some(byte),
                Some(first) if self.big_endian => {
                    self.unit(u16::from_be_bytes([first, byte]), &mut text);
                }
                Some(first) => self.unit(u16::from_le_bytes([first, byte]), &mut text),
            }
        }
        text
    }

    fn unit(&mut self, unit: u16, text: &mut Vec<u8>) {
        if unit < 0x80 && self.high_surrogate.is_none() {
            text.push(unit as u8);
            return;
        }
        let units: &[u16] = match self.high_surrogate.take() {
            Some(high) => &[high, unit],
            None if (0xD800..0xDC00).contains(&unit) => {
                self.high_surrogate = Some(unit);
                return;
            }
            None => &[unit],
        };
        write_units(units, text);
    }

    fn finish(&mut self) -> Vec<u8> {
        let mut text = Vec::new();
        let half = self.half_unit.take().map(|_| 0xDC00);
        let rest: Vec<u16> = self.high_surrogate.take().into_iter().chain(half).collect();
        write_units(&rest[..rest.len().min(1)], &mut text);
        text
    }
}

fn write_units(units: &[u16], text: &mut Vec<u8>) {
    let characters = char::decode_utf16(units.iter().copied());
    for character in characters.map(|unit| unit.unwrap_or(char::REPLACEMENT_CHARACTER)) {
        text.extend_from_slice(character.encode_utf8(&mut [0; 4]).as_bytes());
    }
}

/// How the texts of a file are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// UTF-8, ASCII included.
    Utf8,
    /// Shift_JIS, as Japanese tools write it.
    ShiftJis,
    /// Windows-1252, what is left.
    Windows1252,
}

impl Encoding {
    /// The encoding in which all `texts` make sense.
    pub fn of<'a>(texts: impl Iterator<Item = &'a [u8]> + Clone) -> Self {
        if texts.clone().all(|text| core::str::from_utf8(text).is_ok()) {
            return Encoding::Utf8;
        }
        let mut is_japanese = false;
        for text in texts {
            match SHIFT_JIS.decode_without_bom_handling_and_without_replacement(text) {
                Some(text) => is_japanese |= text.chars().any(is_kana_or_kanji),
                None => return Encoding::Windows1252,
            }
        }
        match is_japanese {
            true => Encoding::ShiftJis,
            false => Encoding::Windows1252,
        }
    }

    /// The name that people know it by.
    pub fn name(self) -> &'static str {
        match self {
            Encoding::Utf8 => "UTF-8",
            Encoding::ShiftJis => "Shift_JIS",
            Encoding::Windows1252 => "Windows-1252",
        }
    }

    /// The text of `bytes`; what cannot be decoded becomes U+FFFD.
    pub fn decode(self, bytes: &[u8]) -> Cow<'_, str> {
        match self {
            Encoding::Utf8 => String::from_utf8_lossy(bytes),
            Encoding::ShiftJis => SHIFT_JIS.decode_without_bom_handling(bytes).0,
            Encoding::Windows1252 => WINDOWS_1252.decode_without_bom_handling(bytes).0,
        }
    }
}

/// Kana and kanji of two bytes in Shift_JIS; the half-width kana of one byte are letters such as
/// `ß` in Windows-1252 and prove nothing.
fn is_kana_or_kanji(character: char) -> bool {
    matches!(character, '々' | 'ぁ'..='ゟ' | '゠'..='ヿ' | '一'..='鿿')
}
