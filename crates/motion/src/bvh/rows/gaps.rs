//! Values that are no numbers: their places go in, what stands for them comes out.

use crate::bvh::error::excerpt;
use crate::bvh::notes::Notes;
use crate::bvh::place::Place;
use crate::note::{Note, NoteKind};
use crate::skeleton::{Channel, Skeleton};

/// The gaps of a motion. A column holds its previous value; at the start it takes the first one
/// that comes, and where none ever comes, what the joint has without motion.
#[derive(Debug)]
pub struct Gaps {
    without_motion: Vec<f64>,
    count: usize,
    first: Option<(Place, String, usize)>,
    open: Vec<OpenColumn>,
}

/// A column without a number so far.
#[derive(Debug)]
struct OpenColumn {
    column: usize,
    /// The frames, from 0, that have none.
    frames: usize,
}

impl Gaps {
    /// None so far; `without_motion` holds one value for each column.
    pub fn new(without_motion: Vec<f64>) -> Self {
        Self {
            without_motion,
            count: 0,
            first: None,
            open: Vec::new(),
        }
    }

    /// Whether a column waits for its first number.
    pub fn is_open(&self) -> bool {
        !self.open.is_empty()
    }

    /// What stands for a word that is no number, the next one after `values`.
    pub fn fill(&mut self, word: &[u8], at: Place, values: &[f64]) -> f64 {
        let width = self.without_motion.len().max(1);
        let (frame, column) = (values.len() / width, values.len() % width);
        self.count += 1;
        if self.first.is_none() {
            let word = excerpt(&String::from_utf8_lossy(word));
            self.first = Some((at, word, frame));
        }
        let held = match self.stays_open(column, frame) {
            true => self.without_motion.get(column),
            false => values.get(values.len().wrapping_sub(width)),
        };
        held.copied().unwrap_or(0.0)
    }

    fn stays_open(&mut self, column: usize, frame: usize) -> bool {
        if frame == 0 {
            self.open.push(OpenColumn { column, frames: 1 });
            return true;
        }
        let mut open = self.open.iter_mut();
        match open.find(|open| open.column == column && open.frames == frame) {
            Some(open) => {
                open.frames += 1;
                true
            }
            None => false,
        }
    }

    /// Gives columns that began without a number their first one, `values` holding `frames`
    /// whole frames.
    pub fn settle(&mut self, values: &mut [f64], frames: usize) {
        let width = self.without_motion.len();
        self.open.retain(|open| {
            let is_open = open.frames >= frames;
            if !is_open {
                let first = values[open.frames * width + open.column];
                for frame in 0..open.frames {
                    values[frame * width + open.column] = first;
                }
            }
            is_open
        });
    }

    /// One note about all gaps.
    pub fn note(self, notes: &mut Notes) {
        if let Some((place, word, frame)) = self.first {
            let details = vec![self.count.to_string(), word];
            let note = Note::new(NoteKind::NotANumber, details);
            notes.push(note.at(place.line, place.column).at_frame(frame));
        }
    }
}

/// What the channels are without motion: the OFFSET for a position, else zero; one value for each column.
pub fn without_motion(skeletons: &[Skeleton]) -> Vec<f64> {
    let width = skeletons.iter().map(Skeleton::channel_count).sum();
    let mut values = Vec::with_capacity(width);
    for joint in skeletons.iter().flat_map(|skeleton| &skeleton.joints) {
        values.extend(joint.channels.iter().map(|channel| match channel {
            Channel::Position(axis) => joint.offset[axis.index()],
            _ => 0.0,
        }));
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two columns; a gap is `None`.
    fn filled(motion: &[[Option<f64>; 2]]) -> Vec<f64> {
        let mut gaps = Gaps::new(vec![7.0, 8.0]);
        let mut values = Vec::new();
        let place = Place { line: 1, column: 1 };
        for frame in motion {
            for value in frame {
                let value = value.unwrap_or_else(|| gaps.fill(b"nan", place, &values));
                values.push(value);
            }
            let frames = values.len() / 2;
            gaps.settle(&mut values, frames);
        }
        values
    }

    #[test]
    fn a_column_holds_its_previous_value() {
        let motion = [[Some(1.0), Some(2.0)], [None, Some(3.0)], [None, Some(4.0)]];
        assert_eq!(filled(&motion), [1.0, 2.0, 1.0, 3.0, 1.0, 4.0]);
    }

    #[test]
    fn a_column_begins_with_its_first_number() {
        let motion = [
            [None, None],
            [None, Some(3.0)],
            [Some(5.0), None],
            [None, None],
        ];
        assert_eq!(filled(&motion), [5.0, 3.0, 5.0, 3.0, 5.0, 3.0, 5.0, 3.0]);
    }

    #[test]
    fn a_column_without_any_number_is_at_rest() {
        assert_eq!(
            filled(&[[None, Some(1.0)], [None, Some(1.0)]]),
            [7.0, 1.0, 7.0, 1.0]
        );
    }
}
