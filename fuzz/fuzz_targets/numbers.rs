//! Words of a row: each is the number that `str::parse` makes of it, to the bit, or the file is
//! not read as one.
//!
//! The bytes are words between blanks; for each of them rows are read, in two slices cut within it and in one.

#![no_main]

use libfuzzer_sys::fuzz_target;
use motion::bvh::{ParseError, Reader};
use motion::clip::Clip;

const HEADER: &str = "HIERARCHY
ROOT one
{
 OFFSET 0 0.0 0
 CHANNELS 3 Xrotation Yrotation Zrotation
}
MOTION
Frames: 16
Frame Time: 0.1
";

/// Enough for a block before the row, and one behind it.
const ROWS_BEFORE: usize = 7;
const ROWS_AFTER: usize = 8;

fuzz_target!(|bytes: &[u8]| {
    let Ok(text) = core::str::from_utf8(bytes) else {
        return;
    };
    for word in text.split(|character| character <= ' ') {
        match finite(word) {
            Some(number) => check(word, number),
            None => assert!(!is_read(word), "{word:?} is no number"),
        }
    }
});

/// The number that a word is; none of these needs the reader's own shapes (commas, names).
fn finite(word: &str) -> Option<f64> {
    word.parse().ok().filter(|number: &f64| number.is_finite())
}

fn check(word: &str, number: f64) {
    for cut in (0..=word.len()).chain([word.len() + 1 + word.len() + 1]) {
        let clip = read(word, cut);
        let values = clip.map(|clip| clip.frame_values(0, ROWS_BEFORE).to_vec());
        let bits = values.map(|values| values.into_iter().map(f64::to_bits).collect::<Vec<_>>());
        let expected = [1.5, number, number].map(f64::to_bits).to_vec();
        assert_eq!(bits, Ok(expected), "{word:?} cut at {cut}");
    }
}

/// Whether a clip without any note comes of a word.
fn is_read(word: &str) -> bool {
    !word.is_empty() && read(word, 0).is_ok_and(|clip| clip.frames == 16 && clip.notes.is_empty())
}

/// Rows of three values, cut within the second one of the third row; long enough for a block that
/// is not cut to be read at once.
fn read(word: &str, cut: usize) -> Result<Clip, ParseError> {
    let before = "0.5 -1.25 3\n".repeat(ROWS_BEFORE);
    let row = format!("1.5 {word} {word}\n");
    let after = "-0.125 45.5 6\n".repeat(ROWS_AFTER);
    let (first, second) = row.as_bytes().split_at(4 + cut);
    let mut reader = Reader::new(None);
    reader.push(HEADER.as_bytes())?;
    reader.push(&[before.as_bytes(), first].concat())?;
    reader.push(&[second, after.as_bytes()].concat())?;
    reader.finish()
}
