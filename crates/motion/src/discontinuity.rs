//! Discontinuities: single steps far above all others around them. Noted, never removed.

use crate::note::{Note, NoteKind};
use crate::rest::step;
use crate::track::PelvisTrack;

/// The smallest step that is a discontinuity, in body heights.
const SMALLEST: f64 = 0.03;

/// How many times every other step around it.
const RATIO: f64 = 4.0;

/// Steps looked at on each side; the direct neighbours are skipped, so that a spike of one frame
/// is found.
const AROUND: usize = 10;

/// Steps that there must be on each side.
const FEWEST: usize = 5;

/// One note for each discontinuity, at most one in ten frames, at its frame of the file.
pub fn find(track: &PelvisTrack) -> Vec<Note> {
    let count = track.frames().saturating_sub(1);
    let steps: Vec<f64> = (0..count).map(|n| step(track, n, n + 1)).collect();
    among(&steps, track.first_frame)
}

/// The same among the `steps` ([`crate::rest::step`]) from one frame to the next, the first from
/// the frame `first_frame` of the file.
pub fn among(steps: &[f64], first_frame: usize) -> Vec<Note> {
    let mut notes = Vec::new();
    let mut next = 0;
    for (n, &size) in steps.iter().enumerate() {
        if n >= next && size >= SMALLEST && stands_out(steps, n) {
            let note = Note::new(NoteKind::Discontinuity, vec![format!("{size:.2}")]);
            notes.push(note.at_frame(first_frame + n));
            next = n + AROUND;
        }
    }
    notes
}

fn stands_out(steps: &[f64], n: usize) -> bool {
    let before = &steps[n.saturating_sub(AROUND)..n.saturating_sub(1)];
    let after = &steps[(n + 2).min(steps.len())..(n + AROUND + 1).min(steps.len())];
    let is_above = |other: &f64| steps[n] > RATIO * other;
    before.len() >= FEWEST
        && after.len() >= FEWEST
        && before.iter().all(is_above)
        && after.iter().all(is_above)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn track(values: &[f64]) -> PelvisTrack {
        PelvisTrack {
            coordinates: values.iter().flat_map(|x| [*x, 0.0, 0.0]).collect(),
            joint_count: 1,
            first_frame: 2,
        }
    }

    #[test]
    fn a_jump_and_a_spike_are_found_once() {
        let mut values: Vec<f64> = (0..60).map(|n| 0.001 * f64::from(n)).collect();
        values[30..].iter_mut().for_each(|x| *x += 0.5);
        values[45] += 0.2;
        let notes = find(&track(&values));
        let frames: Vec<_> = notes.iter().map(|note| note.frame).collect();
        assert_eq!(frames, [Some(31), Some(46)]);
    }

    #[test]
    fn fast_movement_is_none() {
        let values: Vec<f64> = (0..60).map(|n| 0.1 * f64::from(n)).collect();
        assert_eq!(find(&track(&values)), []);
        assert_eq!(find(&track(&[])), []);
        assert_eq!(find(&track(&[0.0, 1.0, 1.0])), []);
    }
}
