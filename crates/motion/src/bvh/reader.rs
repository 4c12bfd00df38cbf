//! The reader: slices of a file go in, the clip comes out at the end.

use super::Limits;
use super::encoding::{Encoding, Unmarker};
use super::error::{ErrorKind, ParseError, Place, excerpt};
use super::header::{self, Header};
use super::hierarchy::{self, Hierarchy, TextLine};
use super::lines::{Line, Lines};
use super::number::Mark;
use super::rows::{Plan, Rows, Values};
use crate::clip::{Clip, Performer};
use crate::note::{Note, NoteKind};
use crate::skeleton::{Channel, Skeleton};

/// Reads a file given in slices, cut anywhere.
#[derive(Debug)]
pub struct Reader {
    limits: Limits,
    total_bytes: Option<u64>,
    unmarker: Unmarker,
    lines: Lines,
    stage: Stage,
    hierarchy_lines: Vec<Line>,
    hierarchy_bytes: usize,
    encoding: Encoding,
    hierarchy: Hierarchy,
    header: Header,
    failed: Option<ParseError>,
}

#[derive(Debug)]
enum Stage {
    Hierarchy,
    Header,
    Rows(Box<Rows>),
}

impl Reader {
    /// A reader for a file of `total_bytes`, if known: memory is then reserved once.
    pub fn new(total_bytes: Option<u64>) -> Self {
        Self::with_limits(total_bytes, Limits::DEFAULT)
    }

    /// A reader with limits of one's own.
    pub fn with_limits(total_bytes: Option<u64>, limits: Limits) -> Self {
        Self {
            limits,
            total_bytes,
            unmarker: Unmarker::default(),
            lines: Lines::new(),
            stage: Stage::Hierarchy,
            hierarchy_lines: Vec::new(),
            hierarchy_bytes: 0,
            encoding: Encoding::Utf8,
            hierarchy: Hierarchy::default(),
            header: Header::default(),
            failed: None,
        }
    }

    /// Frames read so far.
    pub fn frames_read(&self) -> usize {
        match &self.stage {
            Stage::Rows(rows) => rows.frames(),
            _ => 0,
        }
    }

    /// Reads the next slice.
    ///
    /// # Errors
    /// The first thing found that cannot be read; every later call gives the same error.
    pub fn push(&mut self, slice: &[u8]) -> Result<(), ParseError> {
        let bytes = self.unmarker.push(slice);
        self.read(&bytes)
    }

    fn read(&mut self, bytes: &[u8]) -> Result<(), ParseError> {
        if let Some(error) = &self.failed {
            return Err(error.clone());
        }
        self.advance(bytes)
            .inspect_err(|error| self.failed = Some(error.clone()))
    }

    fn advance(&mut self, bytes: &[u8]) -> Result<(), ParseError> {
        let mut rest = bytes;
        while !rest.is_empty() {
            if let Stage::Rows(rows) = &mut self.stage {
                return rows.push(rest);
            }
            rest = &rest[self.lines.skip_blank(rest)..];
            let is_at_line_start = self.lines.line().text.is_empty();
            if is_at_line_start && rest.first().is_some_and(|byte| begins_number(*byte)) {
                self.begin_rows()?;
                continue;
            }
            let (taken, line) = self.lines.take(rest);
            rest = &rest[taken..];
            if let Some(line) = line {
                self.line(line)?;
            }
            self.check_length()?;
        }
        Ok(())
    }

    fn check_length(&self) -> Result<(), ParseError> {
        let length = self.hierarchy_bytes + self.lines.line().text.len();
        if length <= self.limits.hierarchy_bytes {
            return Ok(());
        }
        let details = vec![self.limits.hierarchy_bytes.to_string()];
        let place = self.lines.line().place();
        Err(ParseError::new(ErrorKind::LongHierarchy, place, details))
    }

    fn line(&mut self, line: Line) -> Result<(), ParseError> {
        match self.stage {
            Stage::Hierarchy => self.hierarchy_line(line),
            _ => self.header_line(&line),
        }
    }

    fn hierarchy_line(&mut self, mut line: Line) -> Result<(), ParseError> {
        let braces = closing_braces(&line.text);
        if !header::begins(&line.text[braces..]) {
            self.hierarchy_bytes += line.text.len();
            self.hierarchy_lines.push(line);
            return self.check_beginning();
        }
        let rest = line.text.split_off(braces);
        let rest = Line {
            number: line.number,
            indent: line.indent + braces,
            text: rest,
        };
        if !line.text.is_empty() {
            self.hierarchy_lines.push(line);
        }
        self.end_hierarchy("MOTION", rest.place())?;
        self.stage = Stage::Header;
        self.header_line(&rest)
    }

    /// What is no BVH file is said to be none at its beginning.
    fn check_beginning(&self) -> Result<(), ParseError> {
        const LINES: usize = 100;
        if self.hierarchy_lines.len() != LINES {
            return Ok(());
        }
        match self
            .hierarchy_lines
            .iter()
            .any(|line| is_hierarchy(&line.text))
        {
            true => Ok(()),
            false => Err(self.not_bvh()),
        }
    }

    fn not_bvh(&self) -> ParseError {
        let line = self.hierarchy_lines.first().unwrap_or(self.lines.line());
        let text = String::from_utf8_lossy(&line.text);
        ParseError::new(ErrorKind::NotBvh, line.place(), vec![excerpt(&text)])
    }

    fn header_line(&mut self, line: &Line) -> Result<(), ParseError> {
        let text = self.encoding.decode(&line.text);
        self.header.line(&text, line.place());
        Ok(())
    }

    fn end_hierarchy(&mut self, end: &str, place: Place) -> Result<(), ParseError> {
        let lines = core::mem::take(&mut self.hierarchy_lines);
        let is_bvh = lines.iter().any(|line| is_hierarchy(&line.text));
        if !is_bvh {
            self.hierarchy_lines = lines;
            return Err(self.not_bvh());
        }
        self.encoding = Encoding::of(lines.iter().map(|line| line.text.as_slice()));
        let texts: Vec<_> = lines
            .iter()
            .map(|line| self.encoding.decode(&line.text))
            .collect();
        let decoded: Vec<_> = lines
            .iter()
            .zip(&texts)
            .map(|(line, text)| TextLine {
                text,
                place: line.place(),
            })
            .collect();
        self.hierarchy = hierarchy::read(&decoded, (end, place), &self.limits)?;
        Ok(())
    }

    fn begin_rows(&mut self) -> Result<(), ParseError> {
        let line = self.lines.line();
        let (place, number, indent) = (line.place(), line.number, line.indent);
        if matches!(self.stage, Stage::Hierarchy) {
            self.end_hierarchy("the first row", place)?;
        }
        let width = self
            .hierarchy
            .skeletons
            .iter()
            .map(Skeleton::channel_count)
            .sum();
        let plan = Plan {
            width,
            fill: fill(&self.hierarchy.skeletons),
            frames: self.header.frame_count(),
            expected_values: self.expected_values(width),
            mark: self.hierarchy.mark.map(|(mark, _)| mark),
        };
        let rows = Rows::new(plan, self.limits, number, indent);
        self.stage = Stage::Rows(Box::new(rows));
        Ok(())
    }

    /// Values to reserve: as many as the file says, but not more than its size permits, each
    /// taking two bytes at least.
    fn expected_values(&self, width: usize) -> usize {
        let frames = self.header.frame_count().unwrap_or(0);
        let said = frames.saturating_mul(width);
        let possible = self.total_bytes.map_or(0, |bytes| bytes / 2 + 1);
        said.min(usize::try_from(possible).unwrap_or(usize::MAX))
    }

    /// The clip.
    ///
    /// # Errors
    /// What was found wrong before, or that the file ends too early.
    pub fn finish(mut self) -> Result<Clip, ParseError> {
        let rest = self.unmarker.finish();
        self.read(&rest)?;
        let line = self.lines.end();
        let end = line.place();
        if !line.text.is_empty() && !matches!(self.stage, Stage::Rows(_)) {
            self.line(line)?;
        }
        if matches!(self.stage, Stage::Hierarchy) {
            if self.hierarchy_lines.is_empty() {
                return Err(ParseError::new(ErrorKind::Empty, end, Vec::new()));
            }
            self.end_hierarchy("the end of the file", end)?;
        }
        self.clip()
    }

    fn clip(mut self) -> Result<Clip, ParseError> {
        let widths: Vec<_> = self
            .hierarchy
            .skeletons
            .iter()
            .map(Skeleton::channel_count)
            .collect();
        let row_width = widths.iter().sum();
        let stage = core::mem::replace(&mut self.stage, Stage::Header);
        let rows = match stage {
            Stage::Rows(rows) => rows.finish(&widths)?,
            _ => Values {
                values: Vec::new(),
                notes: Vec::new(),
                text_after: None,
            },
        };
        let frames = rows.values.len().checked_div(row_width).unwrap_or(0);
        let frame_time_s = self.header.seconds();
        let notes = self.notes(&rows, frames);
        Ok(Clip {
            performers: performers(self.hierarchy.skeletons),
            values: rows.values,
            row_width,
            frames,
            frame_time_s,
            notes,
        })
    }

    fn notes(&mut self, rows: &Values, frames: usize) -> Vec<Note> {
        let mut notes = core::mem::take(&mut self.hierarchy.notes);
        if let Some((Mark::Comma, place)) = self.hierarchy.mark {
            notes.push(Note::new(NoteKind::DecimalComma, Vec::new()).at(place.line, place.column));
        }
        let encoding = match (self.unmarker.is_utf16(), self.encoding) {
            (true, _) => Some("UTF-16"),
            (false, Encoding::Utf8) => None,
            (false, other) => Some(other.name()),
        };
        if let Some(name) = encoding {
            notes.push(Note::new(NoteKind::Encoding, vec![name.to_owned()]));
        }
        if frames == 0 {
            self.header
                .notes
                .retain(|note| note.kind != NoteKind::FrameTimeMissing);
            notes.push(Note::new(NoteKind::NoMotion, Vec::new()));
        } else {
            notes.extend(self.frame_count_note(frames));
        }
        notes.append(&mut self.header.notes);
        notes.extend(rows.notes.iter().cloned());
        if let Some((place, text)) = &rows.text_after {
            let text = excerpt(&self.encoding.decode(text));
            let note = Note::new(NoteKind::TextAfterMotion, vec![text]);
            notes.push(note.at(place.line, place.column));
        }
        notes.sort_by_key(|note| (note.line.unwrap_or(0), note.column.unwrap_or(0)));
        notes
    }

    fn frame_count_note(&self, frames: usize) -> Option<Note> {
        let Some(said) = &self.header.frames else {
            let note = Note::new(NoteKind::MotionWithoutFrames, vec![frames.to_string()]);
            return Some(match self.header.place() {
                Some(place) => note.at(place.line, place.column),
                None => note,
            });
        };
        let details = vec![said.text.clone(), frames.to_string()];
        let note = Note::new(NoteKind::FrameCount, details).at(said.place.line, said.place.column);
        (self.header.frame_count() != Some(frames)).then_some(note)
    }
}

fn performers(skeletons: Vec<Skeleton>) -> Vec<Performer> {
    let mut first_column = 0;
    let mut performers = Vec::with_capacity(skeletons.len());
    for skeleton in skeletons {
        let width = skeleton.channel_count();
        performers.push(Performer {
            skeleton,
            first_column,
        });
        first_column += width;
    }
    performers
}

/// What stands for values that are no numbers where there is none before and after: the OFFSET
/// for a position, else zero.
fn fill(skeletons: &[Skeleton]) -> Vec<f64> {
    let joints = skeletons.iter().flat_map(|skeleton| &skeleton.joints);
    joints
        .flat_map(|joint| {
            joint.channels.iter().map(|channel| match channel {
                Channel::Position(axis) => joint.offset[axis.index()],
                _ => 0.0,
            })
        })
        .collect()
}

fn closing_braces(text: &[u8]) -> usize {
    text.iter()
        .take_while(|byte| **byte == b'}' || super::lines::is_blank(**byte))
        .count()
}

fn is_hierarchy(text: &[u8]) -> bool {
    [&b"hierarchy"[..], b"root"].iter().any(|keyword| {
        text.get(..keyword.len())
            .is_some_and(|beginning| beginning.eq_ignore_ascii_case(keyword))
    })
}

fn begins_number(byte: u8) -> bool {
    byte.is_ascii_digit() || matches!(byte, b'+' | b'-' | b'.')
}
