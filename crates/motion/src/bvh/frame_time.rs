//! Frame time: the text after `Frame Time:` goes in, seconds and what was assumed come out.

use super::number::{self, Word};
use crate::note::NoteKind;

/// The frame time where a file gives none that is usable.
pub const ASSUMED_S: f64 = 1.0 / 30.0;

/// Rates that tools write in the place of the time, in frames per second.
const USUAL_RATES_HZ: [f64; 26] = [
    15.0, 23.976, 24.0, 25.0, 29.97, 30.0, 48.0, 50.0, 59.94, 60.0, 72.0, 75.0, 90.0, 100.0, 120.0,
    144.0, 150.0, 180.0, 200.0, 240.0, 250.0, 300.0, 360.0, 480.0, 500.0, 1000.0,
];

/// Seconds from frame to frame, and the kind of the note if they are not as written.
pub fn seconds(text: &str) -> (f64, Option<NoteKind>) {
    let invalid = (ASSUMED_S, Some(NoteKind::FrameTimeInvalid));
    let Word::Number(value) = number::word(text.as_bytes()) else {
        return invalid;
    };
    let read = if value < 1.0 {
        (value, None)
    } else if USUAL_RATES_HZ.iter().any(|rate| is_near(value, *rate)) {
        (1.0 / value, Some(NoteKind::FrameTimeIsRate))
    } else if value < 4.0 {
        (value, Some(NoteKind::FrameTimeIsSeconds))
    } else if value <= 250.0 {
        (value / 1000.0, Some(NoteKind::FrameTimeIsMilliseconds))
    } else {
        return invalid;
    };
    match is_usable(read.0) {
        true => read,
        false => invalid,
    }
}

fn is_near(value: f64, rate: f64) -> bool {
    (value - rate).abs() <= 0.001 * rate
}

/// From 0.25 to 2 000 frames per second.
fn is_usable(seconds: f64) -> bool {
    (1.0 / 2000.0..=4.0).contains(&seconds)
}
