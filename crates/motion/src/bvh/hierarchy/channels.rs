//! CHANNELS: the words after the keyword go in, the channels come out.

use super::cursor::Cursor;
use crate::bvh::place::Place;
use crate::skeleton::{Axis, Channel};

/// A CHANNELS line, which may go on in the next ones.
#[derive(Clone, Debug)]
pub struct Channels<'t> {
    /// The place of the keyword.
    pub place: Place,
    /// The joint that the channels belong to.
    pub joint: usize,
    /// The count as the file says it.
    pub said: &'t str,
    /// The channels found so far.
    pub found: usize,
    count: Option<usize>,
}

impl<'t> Channels<'t> {
    /// Begins after the keyword; returns where the names begin.
    pub fn begin(joint: usize, place: Place, after: Cursor<'t>) -> (Self, Cursor<'t>) {
        let (said, names) = after.word();
        let count = said.parse().ok();
        let channels = Self {
            place,
            joint,
            said: if count.is_some() { said } else { "nothing" },
            found: 0,
            count,
        };
        (channels, if count.is_some() { names } else { after })
    }

    /// Takes the next word, if it is the name of a channel of this joint. What is neither a
    /// position nor a rotation counts only on the line of the keyword and while the count that
    /// the file says is not reached.
    pub fn take(&mut self, at: Cursor<'t>) -> Option<(Channel, Cursor<'t>)> {
        let (word, after) = at.word();
        let channel = channel(word);
        let is_missing = self.count.is_some_and(|count| self.found < count);
        let is_same_line = at.line() == self.place.line;
        let is_taken = match channel {
            Channel::Other => is_same_line && is_missing && !word.is_empty(),
            _ => is_same_line || is_missing,
        };
        self.found += usize::from(is_taken);
        is_taken.then_some((channel, after))
    }

    /// Whether as many were found as the file says.
    pub fn is_as_said(&self) -> bool {
        self.count == Some(self.found)
    }
}

/// The channel of a name in any case.
fn channel(name: &str) -> Channel {
    let axis = match name.as_bytes().first() {
        Some(b'x' | b'X') => Axis::X,
        Some(b'y' | b'Y') => Axis::Y,
        Some(b'z' | b'Z') => Axis::Z,
        _ => return Channel::Other,
    };
    match &name[1..] {
        kind if kind.eq_ignore_ascii_case("position") => Channel::Position(axis),
        kind if kind.eq_ignore_ascii_case("rotation") => Channel::Rotation(axis),
        _ => Channel::Other,
    }
}
