//! Odd files found in the wild: each gives a clip with the notes listed here, or one error.

mod support;

use std::fs;

use motion::bvh::parse;

/// File, then frames × values, then `line kind` of every note or of the error.
const FILES: &[(&str, &str, &[&str])] = &[
    ("cr_only_line_endings", "514 × 162", &[]),
    ("frames1_two_rows", "2 × 66", &["128 frame-count"]),
    (
        "frames_line_without_motion_line",
        "59 × 96",
        &[
            "185 frames-without-motion",
            "185 frame-time-missing",
            "185 frame-count",
        ],
    ),
    ("full_precision_frame_time", "3 × 9", &[]),
    ("hierarchy_only", "0 × 156", &["0 no-motion"]),
    ("joint_with_2_channels", "2 × 56", &[]),
    ("mixed_3_and_6_channels", "50 × 162", &[]),
    ("motion_without_frames", "0 × 96", &["0 no-motion"]),
    ("no_end_site", "120 × 15", &["14 missing-end-site"]),
    ("one_frame", "1 × 18", &[]),
    ("root_with_4_channels", "2 × 55", &["2 partial-position"]),
    ("rotation_channels_before_position", "4 × 15", &[]),
    (
        "two_hierarchies_in_one_file",
        "726 × 156",
        &[
            "101 missing-end-site",
            "135 missing-end-site",
            "147 repeated-hierarchy",
            "148 several-performers",
            "247 missing-end-site",
            "281 missing-end-site",
            "296 alternating-rows",
        ],
    ),
    ("values_only_no_header", "error", &["1 not-bvh"]),
];

fn found(bytes: &[u8]) -> (String, Vec<String>) {
    match parse(bytes) {
        Ok(clip) => {
            let notes = clip.notes.iter();
            let notes =
                notes.map(|note| format!("{} {}", note.line.unwrap_or(0), note.kind.name()));
            (
                format!("{} × {}", clip.frames, clip.row_width),
                notes.collect(),
            )
        }
        Err(error) => (
            "error".to_owned(),
            vec![format!("{} {}", error.line, error.kind.name())],
        ),
    }
}

#[test]
fn odd_files_of_the_wild_are_read() {
    let Some(folder) = support::data_folder() else {
        return;
    };
    for (name, size, notes) in FILES {
        let path = folder.join("broken").join(name).with_extension("bvh");
        let bytes = fs::read(path).expect("a readable file");
        let (found_size, found_notes) = found(&bytes);
        assert_eq!(
            (found_size.as_str(), found_notes),
            (*size, notes.iter().map(|note| (*note).to_owned()).collect()),
            "{name}"
        );
    }
}
