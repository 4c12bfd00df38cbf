//! All before the rows: lines go in; the skeletons and what the motion's header says come out.

use std::borrow::Cow;

use super::Limits;
use super::encoding::Encoding;
use super::error::{ErrorKind, ParseError, excerpt};
use super::header::{self, Header};
use super::hierarchy::{self, Cursor, Hierarchy};
use super::lines::{Line, Lines};
use super::notes::Notes;
use super::number::{self, Word};
use super::place::{Place, Position, is_blank};
use crate::note::NoteKind;

/// Bytes within which a file shows that it is BVH.
const BEGINNING: usize = 64 << 10;

/// Lines of a usual hierarchy.
const USUAL_LINES: usize = 256;

/// Reads the hierarchy and the header of the motion.
#[derive(Debug)]
pub struct Head {
    limits: Limits,
    lines: Lines,
    /// Lines of the hierarchy: their encoding shows only when all are there.
    kept: Vec<Line>,
    kept_bytes: usize,
    is_bvh: bool,
    has_hierarchy: bool,
    /// The hierarchy; empty until it has ended.
    pub hierarchy: Hierarchy,
    /// The encoding of the names.
    pub encoding: Encoding,
    /// The header of the motion.
    pub header: Header,
    /// What was assumed.
    pub notes: Notes,
    /// The first row, where it begins with a word that had to be read to know it as a row.
    pub first_row: Vec<u8>,
}

impl Head {
    /// Before the first line.
    pub fn new(limits: Limits) -> Self {
        Self {
            limits,
            lines: Lines::new(),
            kept: Vec::with_capacity(USUAL_LINES),
            kept_bytes: 0,
            is_bvh: false,
            has_hierarchy: false,
            hierarchy: Hierarchy::default(),
            encoding: Encoding::Utf8,
            header: Header::default(),
            notes: Notes::default(),
            first_row: Vec::new(),
        }
    }

    /// Reads on; returns the bytes taken. Unless all were taken, the first row begins, with
    /// [`Self::first_row`] if that is not empty.
    pub fn push(&mut self, bytes: &[u8]) -> Result<usize, ParseError> {
        let mut at = 0;
        while at < bytes.len() {
            at += self.lines.skip_blank(&bytes[at..]);
            if bytes.get(at).is_some_and(|byte| self.is_row_start(*byte)) {
                self.begin_rows()?;
                return Ok(at);
            }
            let room = self.limit() + 1 - self.length();
            let (taken, line) = self.lines.take(&bytes[at..], room);
            at += taken;
            match line {
                Some(line) => self.line(line)?,
                None => self.check_length()?,
            }
            if !self.first_row.is_empty() {
                return Ok(at);
            }
        }
        Ok(at)
    }

    /// Where the first row begins.
    pub fn row_start(&self) -> Position {
        let line = self.lines.line();
        Position::new(line.number, line.indent)
    }

    /// The end of the file, before any row.
    pub fn finish(&mut self) -> Result<(), ParseError> {
        let line = self.lines.end();
        let end = Cursor::new("the end of the file", line.place());
        if !line.text.is_empty() {
            self.line(line)?;
        }
        if self.has_hierarchy {
            return Ok(());
        }
        if self.kept.is_empty() {
            let first = Place { line: 1, column: 1 };
            return Err(ParseError::new(ErrorKind::Empty, first, Vec::new()));
        }
        self.end_hierarchy(end)
    }

    /// Bytes kept and those of the line so far.
    fn length(&self) -> usize {
        self.kept_bytes + self.lines.text().len()
    }

    fn limit(&self) -> usize {
        match self.is_bvh || is_beginning(self.lines.text()) {
            true => self.limits.hierarchy_bytes,
            false => BEGINNING.min(self.limits.hierarchy_bytes),
        }
    }

    fn check_length(&self) -> Result<(), ParseError> {
        let limit = self.limit();
        if self.length() <= limit {
            return Ok(());
        }
        if limit < self.limits.hierarchy_bytes {
            return Err(self.not_bvh());
        }
        let place = self.lines.line().place();
        Err(ParseError::new(
            ErrorKind::LongHierarchy,
            place,
            vec![limit.to_string()],
        ))
    }

    fn line(&mut self, line: Line) -> Result<(), ParseError> {
        if !self.has_hierarchy {
            return self.hierarchy_line(line);
        }
        let text = self.text(&line);
        match begins_with_no_number(text) {
            true => self.first_row = text.to_vec(),
            false => self.header_line(&line),
        }
        Ok(())
    }

    fn text(&self, line: &Line) -> &[u8] {
        &self.lines.texts()[line.text.clone()]
    }

    fn hierarchy_line(&mut self, mut line: Line) -> Result<(), ParseError> {
        let text = self.text(&line);
        let braces = closing_braces(text);
        if !header::begins(&text[braces..]) {
            return self.keep(line);
        }
        let rest = line.split_off(braces);
        self.keep(line)?;
        self.end_hierarchy(Cursor::new("MOTION", rest.place()))?;
        self.header_line(&rest);
        Ok(())
    }

    fn keep(&mut self, line: Line) -> Result<(), ParseError> {
        let text = self.text(&line);
        let Some(first) = text.first() else {
            return Ok(());
        };
        let is_number = begins_number(*first);
        self.is_bvh = self.is_bvh || is_beginning(text);
        self.kept_bytes += line.text.len();
        self.kept.push(line);
        match is_number && !self.is_bvh {
            true => Err(self.not_bvh()),
            false => Ok(()),
        }
    }

    fn header_line(&mut self, line: &Line) {
        let text = self.encoding.decode(&self.lines.texts()[line.text.clone()]);
        self.header.line(&text, line.place(), &mut self.notes);
        self.lines.forget(line);
    }

    /// Whether a line that begins so is a row: after the header, or after the last brace where
    /// there is none.
    fn is_row_start(&self, byte: u8) -> bool {
        let is_after_brace = || {
            let last = self.kept.last();
            last.is_some_and(|line| self.text(line).trim_ascii_end().ends_with(b"}"))
        };
        self.lines.text().is_empty()
            && begins_number(byte)
            && (self.has_hierarchy || (self.is_bvh && is_after_brace()))
    }

    fn begin_rows(&mut self) -> Result<(), ParseError> {
        if self.has_hierarchy {
            return Ok(());
        }
        let place = self.lines.line().place();
        self.end_hierarchy(Cursor::new("the first row", place))?;
        self.header.begin_without_motion(place);
        self.notes.add(NoteKind::MissingMotion, place, Vec::new());
        Ok(())
    }

    fn end_hierarchy(&mut self, end: Cursor<'_>) -> Result<(), ParseError> {
        if !self.is_bvh {
            return Err(self.not_bvh());
        }
        let mut kept = core::mem::take(&mut self.kept);
        let length = kept.last().map_or(0, |line| line.text.end);
        let texts = &self.lines.texts()[..length];
        self.encoding = Encoding::of(texts);
        let texts = self.encoding.decode(texts);
        if let Cow::Owned(decoded) = &texts {
            set_texts(&mut kept, decoded);
        }
        let lines = kept
            .iter()
            .map(|line| Cursor::new(&texts[line.text.clone()], line.place()));
        self.hierarchy = hierarchy::read(lines, end, &self.limits, &mut self.notes)?;
        self.has_hierarchy = true;
        Ok(())
    }

    fn not_bvh(&self) -> ParseError {
        let line = self.kept.first().cloned();
        let line = line.unwrap_or_else(|| self.lines.line());
        let text = String::from_utf8_lossy(self.text(&line));
        ParseError::new(ErrorKind::NotBvh, line.place(), vec![excerpt(&text)])
    }
}

/// Tells lines where their texts are among those decoded.
fn set_texts(lines: &mut [Line], decoded: &str) {
    let mut start = 0;
    for (line, text) in lines.iter_mut().zip(decoded.split('\n')) {
        line.text = start..start + text.len();
        start = line.text.end + 1;
    }
}

fn closing_braces(text: &[u8]) -> usize {
    let braces = text
        .iter()
        .take_while(|byte| **byte == b'}' || is_blank(**byte));
    braces.count()
}

/// Whether a line begins a BVH file.
fn is_beginning(text: &[u8]) -> bool {
    ["hierarchy", "root"].iter().any(|keyword| {
        let (beginning, after) = text.split_at(keyword.len().min(text.len()));
        let is_whole = after
            .first()
            .is_none_or(|byte| !byte.is_ascii_alphanumeric());
        beginning.eq_ignore_ascii_case(keyword.as_bytes()) && is_whole
    })
}

fn begins_number(byte: u8) -> bool {
    byte.is_ascii_digit() || matches!(byte, b'+' | b'-' | b'.')
}

/// Whether a text begins with `nan` or the like.
fn begins_with_no_number(text: &[u8]) -> bool {
    let mut words = text.split(|byte| is_blank(*byte));
    words
        .next()
        .is_some_and(|word| number::word(word) == Word::NotANumber)
}
