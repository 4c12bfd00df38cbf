//! The notes of one reading: however many there are to make, a bounded number is kept.

use std::collections::BTreeMap;

use super::place::Place;
use crate::note::{Note, NoteKind};

/// Notes kept of one kind.
const KEPT_OF_A_KIND: usize = 100;

/// Notes in the order in which they were made.
#[derive(Debug, Default)]
pub struct Notes {
    kept: Vec<Note>,
    counts: BTreeMap<NoteKind, usize>,
}

impl Notes {
    /// Makes a note about a place.
    pub fn add(&mut self, kind: NoteKind, at: Place, details: Vec<String>) {
        self.push(Note::new(kind, details).at(at.line, at.column));
    }

    /// Makes a note.
    pub fn push(&mut self, note: Note) {
        let count = self.counts.entry(note.kind).or_insert(0);
        *count += 1;
        if *count <= KEPT_OF_A_KIND {
            self.kept.push(note);
        }
    }

    /// Whether a note of a kind was made.
    pub fn contains(&self, kind: NoteKind) -> bool {
        self.counts.contains_key(&kind)
    }

    /// Adds all of `others`.
    pub fn append(&mut self, others: Notes) {
        for (kind, count) in others.counts {
            let kept = others.kept.iter().filter(|note| note.kind == kind).count();
            *self.counts.entry(kind).or_insert(0) += count - kept;
        }
        for note in others.kept {
            self.push(note);
        }
    }

    /// All notes in the order of the file, those about the whole of it first; what was too much
    /// of a kind is counted at the end.
    pub fn in_order(mut self) -> Vec<Note> {
        self.kept
            .sort_by_key(|note| (note.line.unwrap_or(0), note.column.unwrap_or(0)));
        for (kind, count) in self
            .counts
            .iter()
            .filter(|(_, count)| **count > KEPT_OF_A_KIND)
        {
            let further = (count - KEPT_OF_A_KIND).to_string();
            let details = vec![further, kind.name().to_owned()];
            self.kept.push(Note::new(NoteKind::FurtherNotes, details));
        }
        self.kept
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_notes_of_a_kind_are_bounded_and_the_rest_counted() {
        let mut notes = Notes::default();
        for line in (1..=150).rev() {
            notes.add(
                NoteKind::UnknownLine,
                Place { line, column: 1 },
                vec!["?".into()],
            );
        }
        let notes = notes.in_order();
        assert_eq!(notes.len(), 101);
        assert_eq!(notes[0].line, Some(51));
        assert_eq!(
            notes[100].message(),
            "50 more notes of the kind “unknown-line” were left out."
        );
    }
}
