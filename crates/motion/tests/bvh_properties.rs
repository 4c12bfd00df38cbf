//! What holds for all files: any bytes give a clip or an error, and the same one however the file
//! is cut into slices.

mod support;

use std::fs;

use motion::bvh::{ParseError, Reader, parse};
use motion::clip::Clip;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};

const FILE: &str = "\u{FEFF}HIERARCHY
ROOT 腰 one
{
  OFFSET 0 1 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Spine {
    OFFSET 0.0 10.0 0.0
    CHANNELS 3 Xposition Yposition Zposition
    End Site
    { OFFSET 0 5 0 } } }
MOTION\r
Frames: 3\r
Frame Time: 0.04\r
1.5 -2 3e1 4 5.25 6 0.07 0.08 0.09\r
1 2 3 nan 5 6 0.07 -0.08 0.1\r
1 2 3 4 5 6 7 8 12345678901234567890.123\r
# the end 🦴";

/// Pieces that files are made of, and some that break them.
const PIECES: &[&str] = &[
    "HIERARCHY\n",
    "ROOT a\n{\n",
    "JOINT b\n{\n",
    "JOINT c {",
    "End Site\n{\n",
    "{",
    "}",
    "}\n",
    "OFFSET 1 2 3\n",
    "OFFSET 1,5 0 0\n",
    "CHANNELS 3 Xrotation Yrotation Zrotation\n",
    "CHANNELS 1 Xposition\n",
    "CHANNELS 2 Xscale\n",
    "MOTION\n",
    "Frames: 2\n",
    "Frame Time: 0.1\n",
    "Frame Time: 120\n",
    "1 2 3\n",
    "1.5 2.5\n",
    "-1e3 ",
    "4,5 ",
    "nan ",
    "inf 2\n",
    "1.#IND ",
    "1e999 ",
    "\r",
    "\n",
    "\t",
    " ",
    "\0",
    "é",
    "腕",
    "text ",
    "-",
    "1e",
    ".",
];

/// A performer with three values a row.
const ROOT_OF_THREE: &str = "HIERARCHY
ROOT one
{
  OFFSET 0.0 0.0 0.0
  CHANNELS 3 Zrotation Xrotation Yrotation
}
";

fn read_in_slices(bytes: &[u8], cuts: &[usize]) -> Result<Clip, ParseError> {
    let mut reader = Reader::new(Some(bytes.len() as u64));
    let mut start = 0;
    for &cut in cuts {
        reader.push(&bytes[start..cut])?;
        start = cut;
    }
    reader.push(&bytes[start..])?;
    reader.finish()
}

fn check_clip(clip: &Clip) {
    assert_eq!(clip.values.len(), clip.frames * clip.row_width);
    assert!(clip.values.iter().all(|value| value.is_finite()));
    assert!(clip.frame_time_s.is_finite() && clip.frame_time_s > 0.0);
    assert!(!clip.performers.is_empty());
    for performer in &clip.performers {
        let joints = &performer.skeleton.joints;
        assert!(!joints.is_empty() && joints[0].parent.is_none());
        for (index, joint) in joints.iter().enumerate().skip(1) {
            assert!(joint.parent.is_some_and(|parent| parent < index));
        }
        let mut labels = performer.skeleton.labels();
        labels.sort_unstable();
        labels.dedup();
        assert_eq!(labels.len(), joints.len());
    }
}

/// Reads whole, in slices cut at `cuts`, and byte by byte.
fn check(bytes: &[u8], cuts: &[Index]) {
    let whole = parse(bytes);
    match &whole {
        Ok(clip) => check_clip(clip),
        Err(error) => assert!(error.line > 0 && error.column > 0),
    }
    let mut cuts: Vec<_> = cuts.iter().map(|cut| cut.index(bytes.len() + 1)).collect();
    cuts.sort_unstable();
    assert_eq!(read_in_slices(bytes, &cuts), whole, "cut at {cuts:?}");
    let everywhere: Vec<_> = (0..bytes.len()).collect();
    assert_eq!(read_in_slices(bytes, &everywhere), whole, "cut everywhere");
}

/// The file with some of its bytes taken out and pieces put in their place.
fn damaged(edits: &[(Index, usize, &str)]) -> Vec<u8> {
    let mut bytes = FILE.as_bytes().to_vec();
    for (at, length, piece) in edits {
        let start = at.index(bytes.len() + 1);
        let end = (start + length).min(bytes.len());
        bytes.splice(start..end, piece.bytes());
    }
    bytes
}

/// Words of rows: most of a plain file, and some that take other ways.
fn words() -> impl Strategy<Value = String> {
    prop_oneof![
        12 => (-180.0..180.0, 0..9_usize).prop_map(|(value, digits)| format!("{value:.digits$}")),
        2 => any::<f64>().prop_map(|value| format!("{value:e}")),
        1 => "[-+]?[0-9]{0,12}[.]?[0-9]{0,12}",
        1 => select(&["0", "-0", "nan", "1e400", "1,5", "x", "-", "."][..]).prop_map(str::to_owned),
    ]
}

/// What stands between words.
fn blanks() -> impl Strategy<Value = &'static str> {
    prop_oneof![40 => Just(" "), 2 => Just("  "), 1 => Just("\t"), 1 => Just("\x0B")]
}

/// A file of three values a row, of which some rows may be odd.
fn long_file(words: &[(String, &str)], odd_row: Option<usize>, line_end: &str) -> String {
    let mut text = format!("{ROOT_OF_THREE}MOTION\nFrames: 9\nFrame Time: 0.1\n");
    for (index, (word, blank)) in words.iter().enumerate() {
        text += word;
        text += blank;
        let is_row_end = index % 3 == 2 && Some(index) != odd_row;
        text += if is_row_end { line_end } else { "" };
    }
    text
}

fn utf16(bytes: &[u8]) -> Vec<u8> {
    let text = String::from_utf8_lossy(bytes);
    let units = "\u{FEFF}".encode_utf16().chain(text.encode_utf16());
    units.flat_map(u16::to_le_bytes).collect()
}

/// Cases of each property: what `PROPTEST_CASES` says, else 2000.
fn cases() -> u32 {
    let asked = std::env::var("PROPTEST_CASES").ok();
    asked.and_then(|text| text.parse().ok()).unwrap_or(2000)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(cases()))]

    #[test]
    fn any_bytes(bytes in vec(any::<u8>(), 0..300), cuts in vec(any::<Index>(), 0..4)) {
        check(&bytes, &cuts);
    }

    #[test]
    fn pieces_in_any_order(pieces in vec(select(PIECES), 0..40), cuts in vec(any::<Index>(), 0..4)) {
        check(["ROOT a {", &pieces.concat()].concat().as_bytes(), &cuts);
        check(pieces.concat().as_bytes(), &cuts);
    }

    /// Long enough for blocks to be read at once, which bytes one by one never are.
    #[test]
    fn rows_of_any_words(
        words in vec((words(), blanks()), 1..200),
        odd_row in any::<Index>(),
        line_end in select(&["\n", "\r\n", "\r", " \n", "\n\n"][..]),
        cuts in vec(any::<Index>(), 0..4),
    ) {
        check(long_file(&words, Some(odd_row.index(200)), line_end).as_bytes(), &cuts);
    }

    /// As nearly all files are: numbers alone, every bit of which must be right.
    #[test]
    fn rows_of_plain_numbers(
        numbers in vec((-1000.0..1000.0, 0..9_usize), 3..200),
        line_end in select(&["\n", "\r\n", " \n"][..]),
        cuts in vec(any::<Index>(), 0..4),
    ) {
        let word = |(value, digits): &(f64, usize)| (format!("{value:.digits$}"), " ");
        let words: Vec<_> = numbers.iter().map(word).collect();
        let words = &words[..words.len() / 3 * 3];
        let text = long_file(words, None, line_end);
        check(text.as_bytes(), &cuts);
        let values = parse(text.as_bytes()).expect("a clip").values;
        let bits = values.into_iter().map(f64::to_bits);
        let expected = words.iter().map(|(word, _)| word.parse().map(f64::to_bits));
        assert_eq!(bits.map(Ok).collect::<Vec<_>>(), expected.collect::<Vec<_>>());
    }

    #[test]
    fn a_damaged_file(
        edits in vec((any::<Index>(), 0..30_usize, select(PIECES)), 0..4),
        cuts in vec(any::<Index>(), 0..6),
    ) {
        let bytes = damaged(&edits);
        check(&bytes, &cuts);
        check(&utf16(&bytes), &cuts);
    }
}

#[test]
fn words_longer_than_any_number_are_the_same_in_slices() {
    for length in [4090, 4095, 4096, 4097, 5000] {
        for filler in ["0", "x"] {
            let word = filler.repeat(length);
            let bytes = FILE.replacen("1 2 3", &format!("1 {word} 3"), 1);
            let whole = parse(bytes.as_bytes());
            let cuts: Vec<_> = (0..bytes.len()).step_by(7).collect();
            assert_eq!(read_in_slices(bytes.as_bytes(), &cuts), whole);
        }
    }
}

#[test]
fn every_recording_is_read_the_same_in_slices() {
    let Some(folder) = support::data_folder() else {
        return;
    };
    for name in ["broken", "rigs", "cmu"] {
        for entry in fs::read_dir(folder.join(name)).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.extension().is_none_or(|extension| extension != "bvh") {
                continue;
            }
            let bytes = fs::read(&path).expect("a readable file");
            let whole = parse(&bytes);
            let is_values_only = path.ends_with("values_only_no_header.bvh");
            assert_eq!(whole.is_ok(), !is_values_only, "{}", path.display());
            let cuts: Vec<_> = (0..bytes.len()).step_by(9973).collect();
            assert_eq!(read_in_slices(&bytes, &cuts), whole, "{}", path.display());
            whole.iter().for_each(check_clip);
        }
    }
}
