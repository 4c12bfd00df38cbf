//! The rows: slices of the text after the header go in; the values come out, with what the shape
//! of the rows says about wrapped and alternating rows.

mod blocks;
mod end;
mod gaps;
mod layout;
mod marks;
mod relative;
mod text_after;
mod words;

pub use relative::JointOf;

use super::Limits;
use super::error::{ErrorKind, ParseError, excerpt};
use super::notes::Notes;
use super::number::{self, Mark, Word, mixed_marks};
use super::place::{Place, Position, is_blank};
use crate::note::NoteKind;
use crate::skeleton::Skeleton;
use gaps::Gaps;
use layout::{Layout, OddRow};
use marks::BLOCK;
use relative::Relative;
use text_after::TextAfter;

/// Bytes that a word may have: no number needs more.
const MAX_WORD: usize = 4096;

/// Bytes gone over, where nothing is plain, before plain blocks are looked for again.
const LONGEST_ODD: usize = 4096;

/// What is known before the first row.
#[derive(Clone, Copy, Debug)]
pub struct Known {
    /// The frame count that the file says.
    pub frames: Option<usize>,
    /// Values to reserve memory for.
    pub expected_values: usize,
    /// The decimal mark of the hierarchy.
    pub mark: Option<Mark>,
    /// What the file may hold at most.
    pub limits: Limits,
}

/// What the rows say.
#[derive(Debug, Default)]
pub struct Motion {
    /// Whole frames, each with the values of all performers.
    pub values: Vec<f64>,
    /// Joints of which the positions are relative to the OFFSET.
    pub relative_joints: Vec<JointOf>,
    /// Text after the rows, in bytes of the file, and its place.
    pub text_after: Option<(Place, Vec<u8>)>,
}

/// Reads rows.
#[derive(Debug)]
pub struct Rows {
    known: Known,
    widths: Vec<usize>,
    width: usize,
    values: Vec<f64>,
    layout: Layout,
    /// Values in the line so far.
    in_line: usize,
    /// The first value too much in the first line.
    first_extra: Option<Place>,
    position: Position,
    /// A word that the end of the last slice cut.
    cut: Option<CutWord>,
    gaps: Gaps,
    relative: Relative,
    text: Option<TextAfter>,
    notes: Notes,
}

#[derive(Debug)]
struct CutWord {
    bytes: Vec<u8>,
    place: Place,
}

impl Rows {
    /// Rows of the performers with these skeletons, from a position in the file.
    pub fn new(skeletons: &[Skeleton], known: Known, position: Position) -> Self {
        let widths: Vec<_> = skeletons.iter().map(Skeleton::channel_count).collect();
        Self {
            known,
            width: widths.iter().sum(),
            widths,
            values: Vec::new(),
            layout: Layout::Unknown,
            in_line: 0,
            first_extra: None,
            position,
            cut: None,
            gaps: Gaps::new(gaps::without_motion(skeletons)),
            relative: Relative::new(skeletons),
            text: None,
            notes: Notes::default(),
        }
    }

    /// Whole frames read so far.
    pub fn frames(&self) -> usize {
        self.values.len().checked_div(self.width).unwrap_or(0)
    }

    /// Reads the next slice.
    pub fn push(&mut self, bytes: &[u8]) -> Result<(), ParseError> {
        let mut at = self.complete_cut(bytes)?;
        let mut odd_bytes = BLOCK;
        while at < bytes.len() && self.text.is_none() {
            let plain_end = self.plain_blocks(bytes, at);
            odd_bytes = match plain_end > at {
                true => BLOCK,
                false => LONGEST_ODD.min(2 * odd_bytes),
            };
            at = self.odd_rows(bytes, plain_end, odd_bytes)?;
        }
        self.text(&bytes[at..])?;
        self.position.end_slice(bytes.len());
        self.settle();
        Ok(())
    }

    /// Reads what no plain block is, number by number, for so many bytes and to the end of what
    /// stands there; returns where the rest begins.
    fn odd_rows(&mut self, bytes: &[u8], start: usize, length: usize) -> Result<usize, ParseError> {
        let end = bytes.len().min(start + length);
        let mut at = start;
        while at < end && self.text.is_none() {
            at = self.plain_numbers(bytes, at);
            if at < bytes.len() {
                at = self.next(bytes, at)?;
            }
        }
        Ok(at)
    }

    /// Reads numbers of the plain shape while nothing else comes. Returns where the rest begins.
    fn plain_numbers(&mut self, bytes: &[u8], start: usize) -> usize {
        let room = self.values.capacity() - self.values.len();
        let room = match self.layout {
            Layout::Stream(_) => room,
            _ => room.min(self.width.saturating_sub(self.in_line)),
        };
        if self.in_line == 0 {
            return start;
        }
        let mark = self.known.mark;
        let mut at = start;
        for _ in 0..room {
            let first = skip_spaces(bytes, at);
            let Some((value, end)) = number::plain(bytes, first, mark) else {
                break;
            };
            if !bytes.get(end).is_some_and(|byte| is_blank(*byte)) {
                break;
            }
            self.values.push(value);
            self.in_line += 1;
            at = end;
        }
        at
    }

    /// Reads whatever comes next; returns where the rest begins.
    fn next(&mut self, bytes: &[u8], at: usize) -> Result<usize, ParseError> {
        let byte = bytes[at];
        if byte == b'\n' || byte == b'\r' {
            self.end_row(self.position.place(at));
            self.position.end_line(byte, at);
            return Ok(at + 1);
        }
        if is_blank(byte) {
            return Ok(at + 1);
        }
        let end = word_end(bytes, at);
        let place = self.position.place(at);
        let word = &bytes[at..end];
        if end < bytes.len() {
            self.word(word, place)?;
            return Ok(end);
        }
        let bytes = limited(word).to_vec();
        self.cut = Some(CutWord { bytes, place });
        Ok(end)
    }

    /// Completes the word that the end of the last slice cut; returns where the rest begins.
    fn complete_cut(&mut self, bytes: &[u8]) -> Result<usize, ParseError> {
        let Some(mut word) = self.cut.take() else {
            return Ok(0);
        };
        let end = word_end(bytes, 0);
        let room = MAX_WORD + 1 - word.bytes.len();
        word.bytes.extend(bytes[..end].iter().take(room));
        if end == bytes.len() {
            self.cut = Some(word);
        } else {
            self.word(&word.bytes, word.place)?;
        }
        Ok(end)
    }

    /// Reads a word of any shape.
    fn word(&mut self, word: &[u8], at: Place) -> Result<(), ParseError> {
        let word = limited(word);
        match number::word(word) {
            _ if word.len() > MAX_WORD => self.text_begins(word, at),
            Word::Number(value) => {
                self.check_mark(word, at)?;
                self.value(value, at)
            }
            Word::NotANumber => {
                let held = self.gaps.fill(word, at, &self.values);
                self.value(held, at)
            }
            Word::Text => self.text_begins(word, at),
        }
    }

    fn check_mark(&mut self, word: &[u8], at: Place) -> Result<(), ParseError> {
        let Some(mark) = number::mark(word) else {
            return Ok(());
        };
        if self.known.mark.is_none() && mark == Mark::Comma {
            self.notes.add(NoteKind::DecimalComma, at, Vec::new());
        }
        let used = *self.known.mark.get_or_insert(mark);
        match used == mark {
            true => Ok(()),
            false => Err(mixed_marks(&String::from_utf8_lossy(word), used, at)),
        }
    }

    fn value(&mut self, value: f64, at: Place) -> Result<(), ParseError> {
        if self.in_line == 0 {
            let begun = self.layout.begin_row(self.width);
            begun.map_err(|row| self.odd_row(row))?;
        }
        if self.in_line == self.width {
            self.extra_value(at)?;
        }
        if self.values.len() == self.values.capacity() {
            self.grow(at)?;
        }
        self.values.push(value);
        self.in_line += 1;
        Ok(())
    }

    fn extra_value(&mut self, at: Place) -> Result<(), ParseError> {
        if self.width == 0 {
            return Err(ParseError::new(ErrorKind::NoChannels, at, Vec::new()));
        }
        match self.layout {
            Layout::Frames(_) => Err(self.long_row(at)),
            Layout::Stream(_) => Ok(()),
            Layout::Unknown => {
                self.first_extra = Some(at);
                Ok(())
            }
        }
    }

    fn long_row(&self, at: Place) -> ParseError {
        ParseError::new(ErrorKind::LongRow, at, vec![self.width.to_string()])
    }

    fn odd_row(&self, row: OddRow) -> ParseError {
        if row.count > self.width {
            return self.long_row(row.place);
        }
        let details = vec![row.count.to_string(), self.width.to_string()];
        ParseError::new(ErrorKind::ShortRow, row.place, details)
    }

    /// Makes room for more values: at first for all that are expected.
    fn grow(&mut self, at: Place) -> Result<(), ParseError> {
        const LEAST: usize = 1024;
        let limit = self.known.limits.values;
        let length = self.values.len();
        if length >= limit {
            let details = vec![limit.to_string()];
            return Err(ParseError::new(ErrorKind::TooManyValues, at, details));
        }
        let wanted = self.known.expected_values.max(2 * length).max(LEAST);
        let more = wanted.min(limit) - length;
        let reserved = self.values.try_reserve_exact(more);
        reserved.map_err(|_| ParseError::new(ErrorKind::OutOfMemory, at, vec![more.to_string()]))
    }

    fn end_row(&mut self, end: Place) {
        if self.in_line == 0 {
            return;
        }
        let row = OddRow {
            count: core::mem::take(&mut self.in_line),
            place: self.first_extra.take().unwrap_or(end),
        };
        self.layout.end_row(row, self.width);
    }

    fn text_begins(&mut self, word: &[u8], at: Place) -> Result<(), ParseError> {
        let is_within_row = self.in_line > 0 && self.in_line != self.width;
        if is_within_row || number::looks_like_one(word) {
            let details = vec![excerpt(&String::from_utf8_lossy(word))];
            return Err(ParseError::new(ErrorKind::NotANumber, at, details));
        }
        self.end_row(at);
        self.text = Some(TextAfter::new(word, at));
        Ok(())
    }

    /// Goes over text after the rows, where no row may follow.
    fn text(&mut self, bytes: &[u8]) -> Result<(), ParseError> {
        let has_all = self
            .known
            .frames
            .is_some_and(|frames| self.frames() >= frames);
        let Some(text) = &mut self.text else {
            return Ok(());
        };
        if !text.finds_row(bytes) || has_all {
            return Ok(());
        }
        let details = vec![excerpt(&String::from_utf8_lossy(&text.text))];
        Err(ParseError::new(
            ErrorKind::TextBetweenRows,
            text.place,
            details,
        ))
    }

    /// What is to be done with whole frames, as they come.
    fn settle(&mut self) {
        let frames = self.frames();
        self.gaps.settle(&mut self.values, frames);
        if !self.gaps.is_open() {
            self.relative.look(&self.values, frames, self.width);
        }
    }
}

fn skip_spaces(bytes: &[u8], start: usize) -> usize {
    let mut at = start;
    while let Some(b' ' | b'\t') = bytes.get(at) {
        at += 1;
    }
    at
}

fn word_end(bytes: &[u8], start: usize) -> usize {
    let length = bytes[start..].iter().position(|byte| is_blank(*byte));
    length.map_or(bytes.len(), |length| start + length)
}

/// As much of a word as shows that it is too long.
fn limited(word: &[u8]) -> &[u8] {
    &word[..word.len().min(MAX_WORD + 1)]
}
