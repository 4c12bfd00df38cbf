//! Any bytes: a clip or an error, the same however they are cut into slices; and an analysis of a
//! short clip ends. The fuzzer watches for panics, time and memory.
//!
//! The bytes are the whole file, so that a finding opens in the app; its last two bytes also say
//! how it is cut.

#![no_main]

use libfuzzer_sys::fuzz_target;
use motion::analysis::{self, Decisions};
use motion::bvh::{Limits, ParseError, Reader, parse};
use motion::clip::Clip;
use motion::keypose::Options;

/// Frames of which an analysis takes some milliseconds.
const FEW_FRAMES: usize = 300;

fuzz_target!(|bytes: &[u8]| {
    let whole = parse(bytes);
    let [.., first, second] = *bytes else {
        assert!(whole.is_err(), "two bytes are no clip");
        return;
    };
    let sizes = [first, second].map(|size| usize::from(size).max(1));
    assert_eq!(
        read(bytes, sizes, None, Limits::DEFAULT),
        whole,
        "cut by {sizes:?}"
    );
    assert_eq!(
        read(bytes, [1, 1], Some(u64::MAX), Limits::DEFAULT),
        whole,
        "byte by byte"
    );
    let _ = read(bytes, sizes, None, few(first));
    if let Ok(clip) = whole {
        check(&clip);
    }
});

/// Reads slices whose sizes take turns.
fn read(
    bytes: &[u8],
    sizes: [usize; 2],
    total_bytes: Option<u64>,
    limits: Limits,
) -> Result<Clip, ParseError> {
    let mut reader = Reader::with_limits(total_bytes, limits);
    let mut rest = bytes;
    for size in sizes.iter().cycle() {
        if rest.is_empty() {
            break;
        }
        let (slice, after) = rest.split_at(rest.len().min(*size));
        reader.push(slice)?;
        rest = after;
    }
    reader.finish()
}

/// Limits that a small file reaches.
fn few(count: u8) -> Limits {
    let count = usize::from(count);
    Limits {
        joints: count,
        hierarchy_bytes: 16 * count,
        values: count,
    }
}

fn check(clip: &Clip) {
    assert_eq!(clip.values.len(), clip.frames * clip.row_width);
    assert!(clip.values.iter().all(|value| value.is_finite()));
    assert!(clip.frame_time_s.is_finite() && clip.frame_time_s > 0.0);
    for note in &clip.notes {
        assert!(!note.message().is_empty());
    }
    if clip.frames <= FEW_FRAMES {
        let found = analysis::analyse(clip, &Decisions::default(), &Options::default());
        assert!(found.is_ok(), "the default options are in range");
    }
}
