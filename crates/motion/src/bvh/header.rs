//! The header of the motion: the lines from MOTION to the first row go in; the frame count and
//! the frame time that they say come out.

use super::error::excerpt;
use super::frame_time;
use super::notes::Notes;
use super::number::{self, Mark, Word};
use super::place::Place;
use crate::note::{Note, NoteKind};

/// A value as the file says it.
#[derive(Clone, Debug)]
pub struct Said {
    /// The word after the colon.
    pub text: String,
    /// The place of the keyword.
    pub place: Place,
}

/// What the header says so far.
#[derive(Debug, Default)]
pub struct Header {
    motion: Option<Place>,
    frames: Option<Said>,
    frame_time: Option<Said>,
}

/// The keywords of the header.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Keyword {
    Motion,
    Frames,
    FrameTime,
}

impl Header {
    /// Reads a line.
    pub fn line(&mut self, text: &str, place: Place, notes: &mut Notes) {
        let (mut rest, mut at) = (text.trim(), place);
        while !rest.is_empty() {
            let Some((keyword, length)) = keyword(rest) else {
                notes.add(NoteKind::UnknownLine, at, vec![excerpt(rest)]);
                return;
            };
            let behind = rest[length..].trim_start();
            let value = match keyword {
                Keyword::Motion => "",
                _ => behind.split_whitespace().next().unwrap_or(""),
            };
            self.set(keyword, value, at, notes);
            let next = behind[value.len()..].trim_start();
            at.column += rest[..rest.len() - next.len()].chars().count();
            rest = next;
        }
    }

    /// The motion begins at a place without any keyword.
    pub fn begin_without_motion(&mut self, at: Place) {
        self.motion = Some(at);
    }

    /// The frame count, if the file says one that is a whole number.
    pub fn frame_count(&self) -> Option<usize> {
        let text = &self.frames.as_ref()?.text;
        match number::word(text.as_bytes()) {
            Word::Number(count) if (0.0..1e15).contains(&count) && count.trunc() == count => {
                Some(count as usize)
            }
            _ => None,
        }
    }

    /// Notes what the file says about the number of frames, if there are `frames`.
    pub fn note_frames(&self, frames: usize, notes: &mut Notes) {
        if frames == 0 {
            notes.push(Note::new(NoteKind::NoMotion, Vec::new()));
        }
        let count = frames.to_string();
        let Some(said) = &self.frames else {
            if frames > 0 {
                notes.add(NoteKind::MotionWithoutFrames, self.place(), vec![count]);
            }
            return;
        };
        if self.frame_count() != Some(frames) {
            notes.add(
                NoteKind::FrameCount,
                said.place,
                vec![said.text.clone(), count],
            );
        }
    }

    /// Seconds from frame to frame; notes what was assumed.
    pub fn seconds(&self, notes: &mut Notes) -> f64 {
        let Some(said) = &self.frame_time else {
            notes.add(NoteKind::FrameTimeMissing, self.place(), Vec::new());
            return frame_time::ASSUMED_S;
        };
        let (seconds, assumed) = frame_time::seconds(&said.text);
        if let Some(kind) = assumed {
            notes.add(kind, said.place, vec![said.text.clone()]);
        } else if is_comma(&said.text) && !notes.contains(NoteKind::DecimalComma) {
            notes.add(NoteKind::DecimalComma, said.place, Vec::new());
        }
        seconds
    }

    /// Where the header begins.
    fn place(&self) -> Place {
        let frames = self.frames.as_ref().map(|said| said.place);
        let first = Place { line: 1, column: 1 };
        self.motion.or(frames).unwrap_or(first)
    }

    fn set(&mut self, keyword: Keyword, value: &str, place: Place, notes: &mut Notes) {
        let text = if value.is_empty() { "nothing" } else { value };
        let said = Said {
            text: text.to_owned(),
            place,
        };
        let is_first = match keyword {
            Keyword::Motion => *self.motion.get_or_insert(place) == place,
            Keyword::Frames => self.frames.get_or_insert(said).place == place,
            Keyword::FrameTime => self.frame_time.get_or_insert(said).place == place,
        };
        if !is_first {
            notes.add(NoteKind::UnknownLine, place, vec![excerpt(value)]);
        } else if keyword == Keyword::Frames && self.motion.is_none() {
            self.motion = Some(place);
            notes.add(NoteKind::FramesWithoutMotion, place, Vec::new());
        }
    }
}

fn is_comma(number: &str) -> bool {
    number::mark(number.as_bytes()) == Some(Mark::Comma)
}

/// Whether a line of the hierarchy is the first of the header.
pub fn begins(text: &[u8]) -> bool {
    /// Longer than any keyword with its colon.
    const ENOUGH: usize = 16;
    let is_other = |byte: &u8| byte.is_ascii_graphic() && !b"fFmM".contains(byte);
    if text.first().is_some_and(is_other) {
        return false;
    }
    let beginning = String::from_utf8_lossy(&text[..text.len().min(ENOUGH)]);
    keyword(&beginning).is_some()
}

/// The keyword at the beginning of `text` and the bytes that it takes with its colon.
fn keyword(text: &str) -> Option<(Keyword, usize)> {
    let keywords: [(&[&str], Keyword); 3] = [
        (&["frame", "time"], Keyword::FrameTime),
        (&["frames"], Keyword::Frames),
        (&["motion"], Keyword::Motion),
    ];
    let mut found = keywords.iter();
    found.find_map(|(words, keyword)| Some((*keyword, length(text, words)?)))
}

/// The bytes that `words`, in any case and with any spaces between them, and a colon take at the
/// beginning of `text`.
fn length(text: &str, words: &[&str]) -> Option<usize> {
    let mut rest = text;
    for word in words {
        rest = rest.trim_start();
        let beginning = rest.get(..word.len())?;
        if !beginning.eq_ignore_ascii_case(word) {
            return None;
        }
        rest = &rest[word.len()..];
    }
    let after = rest.trim_start();
    match after.strip_prefix(':') {
        Some(after) => Some(text.len() - after.len()),
        None if rest.starts_with(char::is_alphanumeric) => None,
        None => Some(text.len() - rest.len()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(lines: &[&str]) -> (Header, Vec<Note>) {
        let (mut header, mut notes) = (Header::default(), Notes::default());
        for (index, line) in lines.iter().enumerate() {
            let place = Place {
                line: index + 1,
                column: 1,
            };
            header.line(line, place, &mut notes);
        }
        (header, notes.in_order())
    }

    #[test]
    fn keywords_in_any_case_and_spacing_are_read() {
        for lines in [
            &["MOTION", "Frames: 12", "Frame Time: 0.04"][..],
            &["motion", "FRAMES:12", "frame time:0.04"],
            &["Motion", "Frame Time : 0.04", "Frames\t12"],
            &["MOTION Frames: 12 FrameTime: 0.04"],
        ] {
            let (header, notes) = read(lines);
            assert_eq!(header.frame_count(), Some(12), "{lines:?}");
            assert_eq!(header.seconds(&mut Notes::default()), 0.04, "{lines:?}");
            assert!(notes.is_empty(), "{notes:?}");
        }
    }

    #[test]
    fn other_words_are_no_keywords() {
        assert!(!begins(b"Motions"));
        assert!(!begins(b"JOINT Motion"));
        assert!(begins(b"Frames:3"));
    }

    #[test]
    fn what_is_said_twice_is_noted() {
        let (header, notes) = read(&["MOTION", "Frames: 1", "Frames: 2"]);
        assert_eq!(header.frame_count(), Some(1));
        assert_eq!(
            (notes[0].kind, notes[0].line),
            (NoteKind::UnknownLine, Some(3))
        );
    }
}
