//! Small odd files, among them all that fuzzing has found: each gives a clip with the notes listed here,
//! or one error, however it is cut into slices.

use std::fs;
use std::path::PathBuf;

use motion::bvh::{ParseError, Reader, parse};
use motion::clip::Clip;

/// File, then frames × values, then `line kind` of every note or of the error.
const FILES: &[(&str, &str, &[&str])] = &[
    ("comma_without_decimals", "error", &["3 not-a-number"]),
    ("cr_only_line_endings", "3 × 9", &[]),
    ("decimal_comma", "2 × 9", &["4 decimal-comma"]),
    ("exponents", "2 × 9", &[]),
    ("exponents_of_many_digits", "2 × 9", &[]),
    ("frames_1_two_rows", "2 × 9", &["17 frame-count"]),
    (
        "frames_line_without_motion_line",
        "2 × 9",
        &[
            "16 frames-without-motion",
            "16 frame-time-missing",
            "16 frame-count",
        ],
    ),
    ("full_precision_frame_time", "2 × 9", &[]),
    ("hierarchy_only", "0 × 9", &["0 no-motion"]),
    ("human_40_frames", "40 × 57", &[]),
    (
        "incomplete_last_row",
        "3 × 9",
        &["17 frame-count", "22 incomplete-last-row"],
    ),
    ("joint_with_2_channels", "2 × 8", &[]),
    ("long_row", "error", &["20 long-row"]),
    ("missing_brace", "2 × 9", &["15 missing-brace"]),
    ("mixed_3_and_6_channels", "3 × 12", &[]),
    ("mixed_decimal_marks", "error", &["20 mixed-decimal-marks"]),
    ("motion_without_frames", "0 × 9", &["0 no-motion"]),
    ("no_end_site", "2 × 9", &["6 missing-end-site"]),
    ("not_a_number", "4 × 9", &["19 not-a-number"]),
    ("one_frame", "1 × 9", &[]),
    (
        "one_line",
        "0 × 9",
        &["0 no-motion", "1 unknown-line", "2 unknown-line"],
    ),
    ("plain", "4 × 9", &[]),
    ("relative_positions", "2 × 9", &["6 relative-positions"]),
    ("root_with_4_channels", "2 × 7", &["2 partial-position"]),
    ("rotation_channels_before_position", "2 × 9", &[]),
    (
        "scale_channels",
        "2 × 12",
        &[
            "9 skipped-channel",
            "9 skipped-channel",
            "9 skipped-channel",
        ],
    ),
    ("shift_jis", "2 × 9", &["0 encoding"]),
    ("short_row", "error", &["20 short-row"]),
    ("six_decimals_crlf", "4 × 9", &[]),
    ("text_after_motion", "2 × 9", &["21 text-after-motion"]),
    ("text_between_rows", "error", &["21 text-between-rows"]),
    (
        "two_hierarchies_in_one_file",
        "3 × 18",
        &[
            "16 repeated-hierarchy",
            "17 several-performers",
            "34 alternating-rows",
        ],
    ),
    (
        "two_performers_in_one_row",
        "2 × 18",
        &["16 several-performers"],
    ),
    ("utf16", "2 × 9", &["0 encoding"]),
    ("values_only_no_header", "error", &["1 not-bvh"]),
    ("windows_1252", "2 × 9", &["0 encoding"]),
    ("wrapped_rows", "4 × 9", &["19 wrapped-rows"]),
];

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/bvh")
}

fn found(read: &Result<Clip, ParseError>) -> (String, Vec<String>) {
    match read {
        Ok(clip) => {
            let notes = clip.notes.iter();
            let shown =
                notes.map(|note| format!("{} {}", note.line.unwrap_or(0), note.kind.name()));
            (
                format!("{} × {}", clip.frames, clip.row_width),
                shown.collect(),
            )
        }
        Err(error) => (
            "error".to_owned(),
            vec![format!("{} {}", error.line, error.kind.name())],
        ),
    }
}

fn read_in_slices(bytes: &[u8], size: usize) -> Result<Clip, ParseError> {
    let mut reader = Reader::new(None);
    for slice in bytes.chunks(size) {
        reader.push(slice)?;
    }
    reader.finish()
}

#[test]
fn every_fixture_gives_what_is_listed() {
    for (name, size, notes) in FILES {
        let bytes = fs::read(folder().join(name).with_extension("bvh")).expect("a readable file");
        let expected = notes.iter().map(|note| (*note).to_owned()).collect();
        assert_eq!(
            found(&parse(&bytes)),
            ((*size).to_owned(), expected),
            "{name}"
        );
    }
}

#[test]
fn every_fixture_is_listed_and_the_same_in_slices() {
    let mut names: Vec<_> = fs::read_dir(folder())
        .expect("a folder")
        .map(|entry| entry.expect("an entry").path())
        .collect();
    names.sort();
    for path in &names {
        let bytes = fs::read(path).expect("a readable file");
        let whole = parse(&bytes);
        for size in [1, 2, 3, 7, 16, 63, 64, 65, 100, 1000] {
            assert_eq!(
                read_in_slices(&bytes, size),
                whole,
                "{} by {size}",
                path.display()
            );
        }
    }
    let stems: Vec<_> = names.iter().filter_map(|path| path.file_stem()).collect();
    let listed: Vec<_> = FILES.iter().map(|(name, ..)| *name).collect();
    assert_eq!(stems, listed);
}
