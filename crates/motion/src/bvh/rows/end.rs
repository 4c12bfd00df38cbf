//! The end of the rows: what was read goes in; whole frames, and notes on what is left, come out.

use super::layout::Shape;
use super::{Motion, Rows};
use crate::bvh::error::ParseError;
use crate::bvh::notes::Notes;
use crate::bvh::number::{self, Word};
use crate::bvh::place::Place;
use crate::note::NoteKind;

impl Rows {
    /// What the rows say, all of them having been read.
    pub fn finish(mut self, notes: &mut Notes) -> Result<Motion, ParseError> {
        self.last_word()?;
        self.end_row(self.position.place(0));
        self.settle();
        let frames = self.frames();
        self.relative.look(&self.values, frames, self.width);
        self.close()?;
        self.gaps.note(&mut self.notes);
        notes.append(self.notes);
        Ok(Motion {
            values: self.values,
            relative_joints: self.relative.joints(),
            text_after: self.text.map(|text| (text.place, text.text)),
        })
    }

    /// Reads the word at the end of the file, unless the end cuts the number off.
    fn last_word(&mut self) -> Result<(), ParseError> {
        let Some(word) = self.cut.take() else {
            return Ok(());
        };
        let is_row_open = self.in_line > 0 && self.in_line < self.width;
        let is_text = number::word(&word.bytes) == Word::Text;
        match is_text && is_row_open && number::is_cut(&word.bytes) {
            true => Ok(()),
            false => self.word(&word.bytes, word.place),
        }
    }

    fn close(&mut self) -> Result<(), ParseError> {
        let shape = self
            .layout
            .shape(self.values.len(), &self.widths, self.known.frames);
        match shape {
            Shape::Plain => {}
            Shape::Incomplete(row) => self.leave_out(row.place),
            Shape::Broken(row) => return Err(self.odd_row(row)),
            Shape::Wrapped(line) => {
                let details = vec![self.width.to_string()];
                self.notes
                    .add(NoteKind::WrappedRows, Place { line, column: 1 }, details);
            }
            Shape::Alternating(line) => {
                let details = vec![self.widths.len().to_string()];
                self.notes.add(
                    NoteKind::AlternatingRows,
                    Place { line, column: 1 },
                    details,
                );
                self.leave_out(self.position.place(0));
            }
        }
        Ok(())
    }

    /// Leaves out what is not a whole frame.
    fn leave_out(&mut self, at: Place) {
        let whole = self.frames() * self.width;
        let left_out = self.values.len() - whole;
        if left_out > 0 {
            self.values.truncate(whole);
            let details = vec![left_out.to_string(), self.width.to_string()];
            self.notes.add(NoteKind::IncompleteLastRow, at, details);
        }
    }
}
