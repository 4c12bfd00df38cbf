//! The rows: slices of the text after the header go in, the values come out, with what the shape
//! of the rows says about wrapped and alternating rows.

use super::Limits;
use super::error::{ErrorKind, ParseError, Place, excerpt};
use super::hierarchy::mixed_marks;
use super::lines::is_blank;
use super::number::{self, Mark, Word};
use crate::note::{Note, NoteKind};

/// What the rows need to know beforehand.
#[derive(Debug)]
pub struct Plan {
    /// Values of a frame.
    pub width: usize,
    /// The values that stand for those at the start that are no numbers, one for each column.
    pub fill: Vec<f64>,
    /// The frame count that the file says.
    pub frames: Option<usize>,
    /// Values to reserve memory for.
    pub expected_values: usize,
    /// The decimal mark of the hierarchy.
    pub mark: Option<Mark>,
}

/// A row that has not the width.
#[derive(Clone, Copy, Debug)]
struct OddRow {
    count: usize,
    /// Where the row ends, or where its first value too much stands.
    place: Place,
}

/// How values lie on lines, by the first of them.
#[derive(Clone, Copy, Debug)]
enum Layout {
    Unknown,
    /// A line is a frame; the odd row, if any, must be the last.
    Frames(Option<OddRow>),
    /// Lines are as they come.
    Stream {
        first: OddRow,
        lines: usize,
        last: usize,
        /// Whether all lines but the last are as long as the first.
        is_even: bool,
    },
}

/// Reads rows.
#[derive(Debug)]
pub struct Rows {
    plan: Plan,
    limits: Limits,
    values: Vec<f64>,
    layout: Layout,
    /// Values in the line so far.
    in_line: usize,
    first_extra: Option<Place>,
    line: usize,
    /// Bytes of the line before the slice, less what of the slice lies before the line.
    line_start: isize,
    after_return: bool,
    /// A word that the end of the last slice cut.
    cut: Vec<u8>,
    gaps: Gaps,
    text: Option<TextAfter>,
    notes: Vec<Note>,
}

/// Values that are no numbers.
#[derive(Debug, Default)]
struct Gaps {
    count: usize,
    first: Option<(Place, String, usize)>,
    /// Columns without a number so far, with the frame up to which that holds.
    open: Vec<(usize, usize)>,
    settled_frames: usize,
}

/// Text after the rows.
#[derive(Debug)]
struct TextAfter {
    place: Place,
    text: Vec<u8>,
    /// Whether the text of its own line is being read.
    in_first_line: bool,
    /// The first word of the line, if rows may still follow.
    word: Option<Vec<u8>>,
}

/// What came out of the rows.
#[derive(Debug)]
pub struct Values {
    /// Whole frames.
    pub values: Vec<f64>,
    /// What was assumed.
    pub notes: Vec<Note>,
    /// Text after the rows.
    pub text_after: Option<(Place, Vec<u8>)>,
}

impl Rows {
    /// At a place in the file: the line, and the characters of it that are already read.
    pub fn new(plan: Plan, limits: Limits, line: usize, characters_before: usize) -> Self {
        Self {
            plan,
            limits,
            values: Vec::new(),
            layout: Layout::Unknown,
            in_line: 0,
            first_extra: None,
            line,
            line_start: -(characters_before as isize),
            after_return: false,
            cut: Vec::new(),
            gaps: Gaps::default(),
            text: None,
            notes: Vec::new(),
        }
    }

    /// Whole frames read so far.
    pub fn frames(&self) -> usize {
        self.values.len().checked_div(self.plan.width).unwrap_or(0)
    }

    /// Reads the next slice.
    pub fn push(&mut self, bytes: &[u8]) -> Result<(), ParseError> {
        let mut at = self.push_cut(bytes)?;
        while at < bytes.len() {
            at = match self.text.is_some() {
                true => self.text_byte(bytes, at)?,
                false => self.next(bytes, at)?,
            };
        }
        self.line_start -= bytes.len() as isize;
        self.settle();
        Ok(())
    }

    fn place(&self, at: usize) -> Place {
        Place {
            line: self.line,
            column: (at as isize - self.line_start + 1) as usize,
        }
    }

    fn error(&self, kind: ErrorKind, at: usize, details: Vec<String>) -> ParseError {
        ParseError::new(kind, self.place(at), details)
    }

    /// Completes the word that the last slice's end cut.
    fn push_cut(&mut self, bytes: &[u8]) -> Result<usize, ParseError> {
        if self.cut.is_empty() {
            return Ok(0);
        }
        let end = word_end(bytes, 0);
        let missing = MAX_WORD.saturating_sub(self.cut.len());
        let kept = bytes[..end].iter().take(missing);
        let length_before = self.cut.len();
        self.cut.extend(kept);
        if end == bytes.len() {
            self.line_start -= 0;
            return Ok(end);
        }
        let word = core::mem::take(&mut self.cut);
        // The word begins before the slice.
        self.line_start += length_before as isize;
        let result = self.word(&word, 0);
        self.line_start -= length_before as isize;
        result?;
        Ok(end)
    }

    fn next(&mut self, bytes: &[u8], at: usize) -> Result<usize, ParseError> {
        let byte = bytes[at];
        if byte == b'\n' || byte == b'\r' {
            self.line_end(bytes, at)?;
            return Ok(at + 1);
        }
        self.after_return = false;
        if is_blank(byte) {
            return Ok(at + 1);
        }
        if let Some((value, end)) = number::plain(bytes, at) {
            if bytes.get(end).is_some_and(|byte| is_blank(*byte)) && self.plan.mark.is_some() {
                self.value(value, at)?;
                return Ok(end);
            }
        }
        let end = word_end(bytes, at);
        if end == bytes.len() {
            self.cut = bytes[at..].iter().copied().take(MAX_WORD).collect();
            return Ok(end);
        }
        self.word(&bytes[at..end], at)?;
        Ok(end)
    }

    fn value(&mut self, value: f64, at: usize) -> Result<(), ParseError> {
        if self.values.len() == self.values.capacity() {
            self.grow(at)?;
        }
        if self.in_line == self.plan.width {
            self.extra_value(at)?;
        } else if self.in_line == 0 {
            self.line_begins()?;
        }
        self.values.push(value);
        self.in_line += 1;
        Ok(())
    }

    fn grow(&mut self, at: usize) -> Result<(), ParseError> {
        let length = self.values.len();
        if length >= self.limits.values {
            let details = vec![self.limits.values.to_string()];
            return Err(self.error(ErrorKind::TooManyValues, at, details));
        }
        let wanted = self.plan.expected_values.max(2 * length).max(1024);
        let more = wanted.min(self.limits.values) - length;
        if self.values.try_reserve_exact(more).is_err() {
            let details = vec![more.to_string()];
            return Err(self.error(ErrorKind::OutOfMemory, at, details));
        }
        Ok(())
    }

    fn extra_value(&mut self, at: usize) -> Result<(), ParseError> {
        if self.plan.width == 0 {
            return Err(self.error(ErrorKind::NoChannels, at, Vec::new()));
        }
        match self.layout {
            Layout::Frames(_) => Err(self.long_row(self.place(at))),
            Layout::Unknown => {
                self.first_extra = Some(self.place(at));
                Ok(())
            }
            Layout::Stream { .. } => Ok(()),
        }
    }

    fn long_row(&self, place: Place) -> ParseError {
        ParseError::new(ErrorKind::LongRow, place, vec![self.plan.width.to_string()])
    }

    fn odd_row(&self, row: OddRow) -> ParseError {
        if row.count > self.plan.width {
            return self.long_row(row.place);
        }
        let details = vec![row.count.to_string(), self.plan.width.to_string()];
        ParseError::new(ErrorKind::ShortRow, row.place, details)
    }

    /// The first value of a line shows that the line before was not the last.
    fn line_begins(&mut self) -> Result<(), ParseError> {
        match &mut self.layout {
            Layout::Frames(Some(row)) => {
                let row = *row;
                Err(self.odd_row(row))
            }
            Layout::Stream { first, last, .. } if *last == self.plan.width => {
                let row = *first;
                Err(self.odd_row(row))
            }
            Layout::Stream {
                first,
                last,
                is_even,
                ..
            } => {
                *is_even &= *last == first.count;
                Ok(())
            }
            _ => Ok(()),
        }
    }

    fn line_end(&mut self, bytes: &[u8], at: usize) -> Result<(), ParseError> {
        let is_second_half = bytes[at] == b'\n' && self.after_return;
        self.after_return = bytes[at] == b'\r';
        if self.in_line > 0 {
            self.row_ends(at);
        }
        self.line += usize::from(!is_second_half);
        self.line_start = at as isize + 1;
        Ok(())
    }

    fn row_ends(&mut self, at: usize) {
        let count = core::mem::take(&mut self.in_line);
        let place = self.first_extra.take().unwrap_or_else(|| self.place(at));
        let row = OddRow { count, place };
        self.layout = match self.layout {
            Layout::Unknown if count == self.plan.width => Layout::Frames(None),
            Layout::Unknown => Layout::Stream {
                first: row,
                lines: 1,
                last: count,
                is_even: true,
            },
            Layout::Frames(_) => Layout::Frames((count != self.plan.width).then_some(row)),
            Layout::Stream {
                first,
                lines,
                is_even,
                ..
            } => Layout::Stream {
                first,
                lines: lines + 1,
                last: count,
                is_even,
            },
        };
    }

    /// Reads a word of any shape, which ends within the slice.
    fn word(&mut self, word: &[u8], at: usize) -> Result<(), ParseError> {
        match number::word(word) {
            Word::Number(value) => {
                self.check_mark(word, at)?;
                self.value(value, at)
            }
            Word::NotANumber => self.gap(word, at),
            Word::Text => self.text_begins(word, at),
        }
    }

    fn check_mark(&mut self, word: &[u8], at: usize) -> Result<(), ParseError> {
        let Some(mark) = number::mark(word) else {
            return Ok(());
        };
        match self.plan.mark {
            Some(used) if used == mark => Ok(()),
            Some(used) => Err(mixed_marks(
                &String::from_utf8_lossy(word),
                used,
                self.place(at),
            )),
            None => {
                self.plan.mark = Some(mark);
                if mark == Mark::Comma {
                    let place = self.place(at);
                    let note = Note::new(NoteKind::DecimalComma, Vec::new());
                    self.notes.push(note.at(place.line, place.column));
                }
                Ok(())
            }
        }
    }

    fn gap(&mut self, word: &[u8], at: usize) -> Result<(), ParseError> {
        let width = self.plan.width.max(1);
        let index = self.values.len();
        let (frame, column) = (index / width, index % width);
        self.gaps.count += 1;
        if self.gaps.first.is_none() {
            let word = excerpt(&String::from_utf8_lossy(word));
            self.gaps.first = Some((self.place(at), word, frame));
        }
        let open = self.gaps.open.iter_mut().find(|open| open.0 == column);
        let held = match open {
            Some(open) if open.1 == frame => {
                open.1 += 1;
                self.plan.fill.get(column).copied()
            }
            None if frame == 0 => {
                self.gaps.open.push((column, 1));
                self.plan.fill.get(column).copied()
            }
            _ => self.values.get(index - width).copied(),
        };
        self.value(held.unwrap_or(0.0), at)
    }

    /// Gives the columns that began without a number their first one.
    fn settle(&mut self) {
        let width = self.plan.width;
        let frames = self.frames();
        let values = &mut self.values;
        let settled = self.gaps.settled_frames;
        self.gaps.open.retain(|&(column, until)| {
            let is_open = until >= frames;
            if !is_open {
                let first = values[until * width + column];
                for frame in 0..until {
                    values[frame * width + column] = first;
                }
            }
            is_open
        });
        self.gaps.settled_frames = settled.max(frames);
    }

    fn text_begins(&mut self, word: &[u8], at: usize) -> Result<(), ParseError> {
        let is_at_row_end = self.in_line == 0 || self.in_line == self.plan.width;
        if !is_at_row_end {
            let details = vec![excerpt(&String::from_utf8_lossy(word))];
            return Err(self.error(ErrorKind::NotANumber, at, details));
        }
        let place = self.place(at);
        if self.in_line > 0 {
            self.row_ends(at);
        }
        self.text = Some(TextAfter {
            place,
            text: word.to_vec(),
            in_first_line: true,
            word: None,
        });
        Ok(())
    }

    /// Goes over text after the rows, up to a row of numbers that should not be there.
    fn text_byte(&mut self, bytes: &[u8], at: usize) -> Result<usize, ParseError> {
        let may_follow = self.plan.frames.is_none_or(|frames| self.frames() < frames);
        let Some(after) = &mut self.text else {
            return Ok(at);
        };
        let byte = bytes[at];
        if after.in_first_line {
            after.in_first_line = byte != b'\n' && byte != b'\r';
            if after.in_first_line && after.text.len() < MAX_WORD {
                after.text.push(byte);
            }
            return Ok(at + 1);
        }
        if !may_follow {
            return Ok(bytes.len());
        }
        match (&mut after.word, byte) {
            (None, byte) if is_blank(byte) => {}
            (None, byte) => after.word = Some(vec![byte]),
            (Some(word), byte) if !is_blank(byte) => {
                if word.len() < MAX_WORD {
                    word.push(byte);
                }
            }
            (Some(word), byte) => {
                let is_number = matches!(number::word(word), Word::Number(_));
                if is_number {
                    let details = vec![excerpt(&String::from_utf8_lossy(&after.text))];
                    return Err(ParseError::new(
                        ErrorKind::TextBetweenRows,
                        after.place,
                        details,
                    ));
                }
                if byte == b'\n' || byte == b'\r' {
                    after.word = None;
                } else {
                    word.clear();
                    word.extend_from_slice(b"#");
                }
            }
        }
        Ok(at + 1)
    }

    /// The values of all whole frames.
    pub fn finish(mut self, performers: &[usize]) -> Result<Values, ParseError> {
        let word = core::mem::take(&mut self.cut);
        if !word.is_empty() {
            let is_last_row_open = self.in_line > 0 && self.in_line < self.plan.width;
            self.line_start -= 0;
            let at = 0;
            let length = word.len() as isize;
            self.line_start += length;
            let is_text = number::word(&word) == Word::Text;
            if !(is_text && is_last_row_open && number::is_cut(&word)) {
                self.word(&word, at)?;
            }
            self.line_start -= length;
        }
        if self.in_line > 0 {
            self.row_ends(0);
        }
        self.settle();
        self.close(performers)?;
        self.note_gaps();
        Ok(Values {
            values: self.values,
            notes: self.notes,
            text_after: self.text.map(|after| (after.place, after.text)),
        })
    }

    fn close(&mut self, performers: &[usize]) -> Result<(), ParseError> {
        let width = self.plan.width;
        match self.layout {
            Layout::Unknown => Ok(()),
            Layout::Frames(None) => Ok(()),
            Layout::Frames(Some(row)) => {
                self.leave_out(row);
                Ok(())
            }
            Layout::Stream {
                first, lines: 1, ..
            } if first.count < width => {
                self.leave_out(first);
                Ok(())
            }
            Layout::Stream {
                first,
                lines,
                last,
                is_even,
            } => {
                let one = performers.iter().all(|own| *own == first.count);
                let is_alternating = performers.len() > 1 && one && is_even && last == first.count;
                let frames = self.plan.frames.map(|frames| frames * performers.len());
                if self.values.len() % width != 0 {
                    return Err(self.odd_row(first));
                }
                let note = match is_alternating && frames == Some(lines) {
                    true => Note::new(
                        NoteKind::AlternatingRows,
                        vec![performers.len().to_string()],
                    ),
                    false => Note::new(NoteKind::WrappedRows, vec![width.to_string()]),
                };
                self.notes.push(note.at(first.place.line, 1));
                Ok(())
            }
        }
    }

    fn leave_out(&mut self, row: OddRow) {
        let width = self.plan.width;
        let whole = self.frames() * width;
        self.values.truncate(whole);
        let details = vec![row.count.to_string(), width.to_string()];
        let note = Note::new(NoteKind::IncompleteLastRow, details);
        self.notes.push(note.at(row.place.line, row.place.column));
    }

    fn note_gaps(&mut self) {
        let Some((place, word, frame)) = self.gaps.first.take() else {
            return;
        };
        let details = vec![self.gaps.count.to_string(), word];
        let note = Note::new(NoteKind::NotANumber, details);
        self.notes
            .push(note.at(place.line, place.column).at_frame(frame));
    }
}

/// No number needs more; what a word has beyond is left out of messages.
const MAX_WORD: usize = 4096;

fn word_end(bytes: &[u8], start: usize) -> usize {
    let length = bytes[start..].iter().position(|byte| is_blank(*byte));
    length.map_or(bytes.len(), |length| start + length)
}
