//! Text after the rows: bytes go in; what of it to show, and whether rows follow, come out.

use super::MAX_WORD;
use crate::bvh::number::{self, Word};
use crate::bvh::place::{Place, is_blank};

/// Text that stands where a row should begin.
#[derive(Debug)]
pub struct TextAfter {
    /// Where it begins.
    pub place: Place,
    /// Its first line.
    pub text: Vec<u8>,
    is_in_first_line: bool,
    word: LineStart,
}

/// The first word of a later line.
#[derive(Debug)]
enum LineStart {
    Word(Vec<u8>),
    GoneOver,
}

impl TextAfter {
    /// Begins with a word.
    pub fn new(word: &[u8], place: Place) -> Self {
        Self {
            place,
            text: word.to_vec(),
            is_in_first_line: true,
            word: LineStart::Word(Vec::new()),
        }
    }

    /// Goes over bytes; true if a line among them begins with a number.
    pub fn finds_row(&mut self, bytes: &[u8]) -> bool {
        bytes.iter().any(|byte| self.is_row_found(*byte))
    }

    fn is_row_found(&mut self, byte: u8) -> bool {
        let is_line_end = byte == b'\n' || byte == b'\r';
        if self.is_in_first_line {
            self.is_in_first_line = !is_line_end;
            if !is_line_end && self.text.len() < MAX_WORD {
                self.text.push(byte);
            }
            return false;
        }
        self.go_over(byte, is_line_end)
    }

    fn go_over(&mut self, byte: u8, is_line_end: bool) -> bool {
        match &mut self.word {
            LineStart::Word(word) if !is_blank(byte) => {
                if word.len() < MAX_WORD {
                    word.push(byte);
                }
                return false;
            }
            LineStart::Word(word) if word.is_empty() => return false,
            LineStart::Word(word) => {
                if matches!(number::word(word), Word::Number(_)) {
                    return true;
                }
                self.word = LineStart::GoneOver;
            }
            LineStart::GoneOver => {}
        }
        if is_line_end {
            self.word = LineStart::Word(Vec::new());
        }
        false
    }
}
