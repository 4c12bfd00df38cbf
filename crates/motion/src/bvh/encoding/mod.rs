//! Encodings: slices of a file go in, bytes of which the ASCII part can be read go out; and texts
//! of an unmarked file, once all are there, become strings.

mod shift_jis;
mod unmarker;
mod windows_1252;

use std::borrow::Cow;

pub use unmarker::Unmarker;

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
    /// The encoding in which a text makes sense.
    pub fn of(text: &[u8]) -> Self {
        if core::str::from_utf8(text).is_ok() {
            return Encoding::Utf8;
        }
        let mut is_japanese = false;
        for character in shift_jis::characters(text) {
            match character {
                Some(character) => is_japanese |= is_kana_or_kanji(character),
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
            Encoding::Utf8 => match core::str::from_utf8(bytes) {
                Ok(text) => Cow::Borrowed(text),
                Err(_) => String::from_utf8_lossy(bytes),
            },
            Encoding::ShiftJis => shift_jis::characters(bytes)
                .map(|character| character.unwrap_or(char::REPLACEMENT_CHARACTER))
                .collect(),
            Encoding::Windows1252 => bytes
                .iter()
                .map(|byte| windows_1252::character(*byte))
                .collect(),
        }
    }
}

/// Kana and kanji of two bytes in Shift_JIS; the half-width kana of one byte are letters such as
/// `ß` in Windows-1252 and prove nothing.
fn is_kana_or_kanji(character: char) -> bool {
    matches!(character, '々' | 'ぁ'..='ゟ' | '゠'..='ヿ' | '一'..='鿿')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &[u8]) -> Encoding {
        Encoding::of(&[b"ROOT hip\n", text].concat())
    }

    #[test]
    fn utf8_comes_first() {
        assert_eq!(of("左腕".as_bytes()), Encoding::Utf8);
        assert_eq!(of(b"plain"), Encoding::Utf8);
    }

    #[test]
    fn kanji_and_kana_of_two_bytes_show_shift_jis() {
        assert_eq!(of(b"\x8D\xB6\x98\x72"), Encoding::ShiftJis);
        assert_eq!(Encoding::ShiftJis.decode(b"\x8D\xB6\x98\x72 1"), "左腕 1");
        // The second byte of ボ is a brace in ASCII.
        assert_eq!(of(b"\x83\x7B\x81\x5B\x83\x93"), Encoding::ShiftJis);
        assert_eq!(
            Encoding::ShiftJis.decode(b"\x83\x7B\x81\x5B\x83\x93"),
            "ボーン"
        );
    }

    #[test]
    fn what_decodes_without_any_is_windows_1252() {
        // ß alone is the half-width kana ﾟ.
        assert_eq!(of(b"Fu\xDF"), Encoding::Windows1252);
        assert_eq!(Encoding::Windows1252.decode(b"Fu\xDF \x80\xFC"), "Fuß €ü");
        assert_eq!(of(b"\x8D\xB6 \xFF"), Encoding::Windows1252);
    }
}
