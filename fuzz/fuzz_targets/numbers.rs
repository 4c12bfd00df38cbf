//! Words of a row: each is the number that `str::parse` makes of it, to the bit, or the file is
//! not read as one.
//!
//! The bytes are words between blanks; a row is read for each of them, in two slices cut within it.

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
Frames: 1
Frame Time: 0.1
";

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
    for cut in 0..=word.len() {
        let clip = read(word, cut);
        let values = clip.map(|clip| clip.values);
        let bits = values.map(|values| values.into_iter().map(f64::to_bits).collect::<Vec<_>>());
        let expected = [1.5, number, number].map(f64::to_bits).to_vec();
        assert_eq!(bits, Ok(expected), "{word:?} cut at {cut}");
    }
}

/// Whether a clip without any note comes of a word.
fn is_read(word: &str) -> bool {
    !word.is_empty() && read(word, 0).is_ok_and(|clip| clip.frames == 1 && clip.notes.is_empty())
}

/// A row of three values, cut within the second of them.
fn read(word: &str, cut: usize) -> Result<Clip, ParseError> {
    let row = format!("1.5 {word} {word}\n");
    let (first, second) = row.as_bytes().split_at(4 + cut);
    let mut reader = Reader::new(None);
    reader.push(HEADER.as_bytes())?;
    reader.push(first)?;
    reader.push(second)?;
    reader.finish()
}
