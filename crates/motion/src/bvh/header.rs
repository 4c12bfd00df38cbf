//! The header of the motion: the lines from MOTION to the first row go in, the frame count and
//! the frame time that they say come out.

use super::error::{Place, excerpt};
use super::frame_time;
use crate::note::{Note, NoteKind};

/// A value as the file says it.
#[derive(Clone, Debug)]
pub struct Said {
    /// The text after the colon.
    pub text: String,
    /// The place of the keyword.
    pub place: Place,
}

/// What the header says so far.
#[derive(Debug, Default)]
pub struct Header {
    /// The place of MOTION.
    pub motion: Option<Place>,
    /// `Frames:`
    pub frames: Option<Said>,
    /// `Frame Time:`
    pub frame_time: Option<Said>,
    /// What was assumed.
    pub notes: Vec<Note>,
}

/// The keywords of the header.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Keyword {
    Motion,
    Frames,
    FrameTime,
}

impl Header {
    /// Reads a line or what is left of one.
    pub fn line(&mut self, text: &str, place: Place) {
        let (mut rest, mut at) = (text.trim(), place);
        while !rest.is_empty() {
            let Some((keyword, length)) = keyword(rest) else {
                self.note(NoteKind::UnknownLine, at, vec![excerpt(rest)]);
                return;
            };
            let value = rest[length..].trim_start();
            let word = value.split_whitespace().next().unwrap_or("");
            let taken = if keyword == Keyword::Motion { "" } else { word };
            self.set(keyword, taken, at);
            let next = value[taken.len()..].trim_start();
            at.column += rest[..rest.len() - next.len()].chars().count();
            rest = next;
        }
    }

    /// The frame count, if the file says one that is a number.
    pub fn frame_count(&self) -> Option<usize> {
        self.frames.as_ref()?.text.parse().ok()
    }

    /// Seconds from frame to frame; notes what was assumed.
    pub fn seconds(&mut self) -> f64 {
        let Some(said) = self.frame_time.clone() else {
            let note = Note::new(NoteKind::FrameTimeMissing, Vec::new());
            self.notes.push(match self.place() {
                Some(place) => note.at(place.line, place.column),
                None => note,
            });
            return frame_time::ASSUMED_S;
        };
        let (seconds, assumed) = frame_time::seconds(&said.text);
        if let Some(kind) = assumed {
            self.note(kind, said.place, vec![said.text]);
        }
        seconds
    }

    /// Where the header begins.
    pub fn place(&self) -> Option<Place> {
        self.motion.or(self.frames.as_ref().map(|said| said.place))
    }

    fn set(&mut self, keyword: Keyword, value: &str, place: Place) {
        let said = Said {
            text: value.to_owned(),
            place,
        };
        let is_first = match keyword {
            Keyword::Motion => self.motion.replace(place).is_none(),
            Keyword::Frames => self.frames.get_or_insert(said).place == place,
            Keyword::FrameTime => self.frame_time.get_or_insert(said).place == place,
        };
        if keyword == Keyword::Frames && self.motion.is_none() {
            self.motion = Some(place);
            self.note(NoteKind::FramesWithoutMotion, place, Vec::new());
        }
        if !is_first {
            self.note(NoteKind::UnknownLine, place, vec![excerpt(value)]);
        }
    }

    fn note(&mut self, kind: NoteKind, place: Place, details: Vec<String>) {
        let note = Note::new(kind, details).at(place.line, place.column);
        self.notes.push(note);
    }
}

/// Whether a line of the hierarchy is the first of the motion's header.
pub fn begins(text: &[u8]) -> bool {
    let beginning = &text[..text.len().min(16)];
    let beginning = String::from_utf8_lossy(beginning);
    matches!(
        keyword(&beginning),
        Some((Keyword::Motion | Keyword::Frames, _))
    )
}

/// The keyword at the beginning of `text` and the bytes that it takes with its colon.
fn keyword(text: &str) -> Option<(Keyword, usize)> {
    const KEYWORDS: [(&[&str], Keyword); 3] = [
        (&["frame", "time"], Keyword::FrameTime),
        (&["frames"], Keyword::Frames),
        (&["motion"], Keyword::Motion),
    ];
    KEYWORDS.iter().find_map(|(words, keyword)| {
        let mut rest = text;
        for word in *words {
            let beginning = rest.get(..word.len())?;
            rest = match beginning.eq_ignore_ascii_case(word) {
                true => rest[word.len()..].trim_start(),
                false => return None,
            };
        }
        let after = rest.strip_prefix(':').unwrap_or(rest);
        let length = text.len() - after.len();
        let is_whole = !text[..length].ends_with(|c: char| c.is_alphanumeric())
            || !after.starts_with(|c: char| c.is_alphanumeric());
        is_whole.then_some((*keyword, length))
    })
}
