//! Shift_JIS: bytes go in, characters come out, as the Encoding Standard of the WHATWG decodes
//! them.

/// UTF-16 units (0 where there is no character) of the 50 lead bytes 0x81–0x9F, 0xE0–0xEF and
/// 0xFA–0xFC with 188 trail bytes each, the index jis0208 of the standard: first the high bytes of
/// all, then the low bytes, which packs better. The tests hold every byte and every pair of bytes
/// against `encoding_rs`, which would add ten times as much to the page.
static UNITS: &[u8] = include_bytes!("shift_jis.bin");

/// Trail bytes of one lead byte: 0x40–0x7E and 0x80–0xFC.
const TRAILS: usize = 188;

/// The characters of `bytes`; none for a byte that cannot be decoded.
pub fn characters(bytes: &[u8]) -> impl Iterator<Item = Option<char>> + '_ {
    let mut rest = bytes;
    core::iter::from_fn(move || {
        let (&first, after) = rest.split_first()?;
        let pair = after.first().and_then(|trail| two_bytes(first, *trail));
        if pair.is_some() {
            rest = &after[1..];
            return Some(pair);
        }
        rest = after;
        Some(one_byte(first))
    })
}

fn one_byte(byte: u8) -> Option<char> {
    match byte {
        0x00..=0x80 => Some(char::from(byte)),
        0xA1..=0xDF => char::from_u32(0xFF61 + u32::from(byte - 0xA1)),
        _ => None,
    }
}

fn two_bytes(lead: u8, trail: u8) -> Option<char> {
    let column = usize::from(match trail {
        0x40..=0x7E => trail - 0x40,
        0x80..=0xFC => trail - 0x41,
        _ => return None,
    });
    let row = usize::from(match lead {
        0x81..=0x9F => lead - 0x81,
        0xE0..=0xEF => lead - 0xC1,
        // Characters of one's own lie in the private use area.
        0xF0..=0xF9 => {
            return char::from_u32(0xE000 + u32::from(lead - 0xF0) * 188 + column as u32);
        }
        0xFA..=0xFC => lead - 0xCB,
        _ => return None,
    });
    let at = row * TRAILS + column;
    let unit = u16::from_be_bytes([*UNITS.get(at)?, *UNITS.get(UNITS.len() / 2 + at)?]);
    char::from_u32(u32::from(unit)).filter(|_| unit != 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn expected(bytes: &[u8]) -> Option<String> {
        encoding_rs::SHIFT_JIS
            .decode_without_bom_handling_and_without_replacement(bytes)
            .map(|text| text.into_owned())
    }

    #[test]
    fn every_pair_of_bytes_is_as_in_the_encoding_standard() {
        for first in 0..=255 {
            for second in 0..=255 {
                let bytes = [first, second];
                let decoded: Option<String> = characters(&bytes).collect();
                assert_eq!(decoded, expected(&bytes), "{bytes:x?}");
            }
        }
    }
}
