//! The reader: slices of a file go in, the clip comes out at the end.

use super::Limits;
use super::encoding::{Encoding, Unmarker};
use super::error::{ParseError, excerpt};
use super::head::Head;
use super::notes::Notes;
use super::place::Place;
use super::rows::{JointOf, Known, Motion, Rows};
use crate::clip::{Clip, Performer};
use crate::note::{Note, NoteKind};
use crate::skeleton::{Channel, Skeleton};

/// Reads a file given in slices, cut anywhere; the clip is the same for every cutting.
///
/// The work of a call is in proportion to its slice; [`Reader::finish`] takes no longer than a
/// slice, so that one who must not work long at a time gives small slices.
#[derive(Debug)]
pub struct Reader {
    limits: Limits,
    total_bytes: Option<u64>,
    unmarker: Unmarker,
    head: Head,
    rows: Option<Rows>,
    failed: Option<ParseError>,
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
            head: Head::new(limits),
            rows: None,
            failed: None,
        }
    }

    /// Whole frames read so far.
    pub fn frames_read(&self) -> usize {
        self.rows.as_ref().map_or(0, Rows::frames)
    }

    /// Reads the next slice.
    ///
    /// # Errors
    /// The first thing found that cannot be read; every later call gives the same error.
    pub fn push(&mut self, slice: &[u8]) -> Result<(), ParseError> {
        if let Some(error) = &self.failed {
            return Err(error.clone());
        }
        let bytes = self.unmarker.push(slice);
        let read = self.read(&bytes);
        read.inspect_err(|error| self.failed = Some(error.clone()))
    }

    /// The clip of all that was read.
    ///
    /// # Errors
    /// What was found wrong before, or at the end of the file.
    pub fn finish(mut self) -> Result<Clip, ParseError> {
        if let Some(error) = self.failed {
            return Err(error);
        }
        let rest = self.unmarker.finish();
        self.read(&rest)?;
        if self.unmarker.is_utf16() {
            self.head.notes.push(encoding_note("UTF-16"));
        }
        if self.rows.is_none() {
            self.head.finish()?;
            self.begin_rows(&[])?;
        }
        let motion = match self.rows {
            Some(rows) => rows.finish(&mut self.head.notes)?,
            None => Motion::default(),
        };
        Ok(clip(self.head, motion))
    }

    fn read(&mut self, bytes: &[u8]) -> Result<(), ParseError> {
        if let Some(rows) = &mut self.rows {
            return rows.push(bytes);
        }
        let taken = self.head.push(bytes)?;
        self.begin_rows(&bytes[taken..])
    }

    /// Begins the rows, if there is a beginning of one.
    fn begin_rows(&mut self, bytes: &[u8]) -> Result<(), ParseError> {
        let first_row = core::mem::take(&mut self.head.first_row);
        if first_row.is_empty() && bytes.is_empty() {
            return Ok(());
        }
        let rows = self.rows.insert(self.new_rows());
        rows.push(&first_row)?;
        rows.push(bytes)
    }

    fn new_rows(&self) -> Rows {
        let skeletons = &self.head.hierarchy.skeletons;
        let width = skeletons.iter().map(Skeleton::channel_count).sum();
        let frames = self.head.header.frame_count();
        let known = Known {
            frames,
            expected_values: self.expected_values(frames.unwrap_or(0), width),
            mark: self.head.hierarchy.mark,
            limits: self.limits,
        };
        Rows::new(skeletons, known, self.head.row_start())
    }

    /// Values to reserve memory for: as many as the file says, but no more than its size
    /// permits, each taking two bytes at least.
    fn expected_values(&self, frames: usize, width: usize) -> usize {
        let possible = self.total_bytes.map_or(0, |bytes| bytes / 2 + 1);
        let possible = usize::try_from(possible).unwrap_or(usize::MAX);
        frames.saturating_mul(width).min(possible)
    }
}

fn clip(head: Head, motion: Motion) -> Clip {
    let Head {
        hierarchy,
        encoding,
        header,
        mut notes,
        ..
    } = head;
    if encoding != Encoding::Utf8 {
        notes.push(encoding_note(encoding.name()));
    }
    let mut performers = performers(hierarchy.skeletons);
    let row_width = performers
        .iter()
        .map(|own| own.skeleton.channel_count())
        .sum();
    let frames = motion.values.len().checked_div(row_width).unwrap_or(0);
    let frame_time_s = match frames {
        0 => header.seconds(&mut Notes::default()),
        _ => header.seconds(&mut notes),
    };
    header.note_frames(frames, &mut notes);
    for joint in motion.relative_joints {
        add_positions(&mut performers, joint, &mut notes);
    }
    if let Some((place, text)) = motion.text_after {
        let text = excerpt(&encoding.decode(&text));
        notes.add(NoteKind::TextAfterMotion, place, vec![text]);
    }
    Clip {
        performers,
        values: motion.values,
        row_width,
        frames,
        frame_time_s,
        notes: notes.in_order(),
    }
}

fn encoding_note(name: &str) -> Note {
    Note::new(NoteKind::Encoding, vec![name.to_owned()])
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

/// Makes the positions of a joint add to its OFFSET instead of replacing it.
fn add_positions(performers: &mut [Performer], at: JointOf, notes: &mut Notes) {
    let joint = &mut performers[at.performer].skeleton.joints[at.joint];
    for channel in &mut joint.channels {
        if let Channel::Position(axis) = *channel {
            *channel = Channel::AddedPosition(axis);
        }
    }
    let place = Place {
        line: joint.line,
        column: 1,
    };
    notes.add(NoteKind::RelativePositions, place, vec![joint.name.clone()]);
}
