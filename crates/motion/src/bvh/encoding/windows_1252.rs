//! Windows-1252: a byte goes in, its character comes out.

/// What differs from Latin-1: the characters of 0x80 to 0x9F. The five bytes without a character
/// are control characters, as in the Encoding Standard of the WHATWG.
const FROM_0X80: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8D}', 'Ž', '\u{8F}',
    '\u{90}', '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9D}', 'ž', 'Ÿ',
];

/// The character of a byte.
pub fn character(byte: u8) -> char {
    match byte {
        0x80..=0x9F => FROM_0X80[usize::from(byte - 0x80)],
        _ => char::from(byte),
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn every_byte_is_as_in_the_encoding_standard() {
        for byte in 0..=255 {
            let bytes = [byte];
            let expected = encoding_rs::WINDOWS_1252
                .decode_without_bom_handling(&bytes)
                .0;
            assert_eq!(String::from(super::character(byte)), expected, "{byte:#x}");
        }
    }
}
