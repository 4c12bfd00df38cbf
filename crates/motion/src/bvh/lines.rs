//! Lines: slices cut anywhere go in, one whole line after the other comes out, with its place.

use super::error::Place;

/// A line without its indent and its end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line {
    /// The number, from 1.
    pub number: usize,
    /// White space before the text, in characters.
    pub indent: usize,
    /// The text as bytes of the file.
    pub text: Vec<u8>,
}

impl Line {
    /// The place of the first character of the text.
    pub fn place(&self) -> Place {
        Place {
            line: self.number,
            column: self.indent + 1,
        }
    }
}

/// Puts lines together.
#[derive(Debug)]
pub struct Lines {
    line: Line,
    after_return: bool,
}

impl Lines {
    /// Before the first line.
    pub fn new() -> Self {
        let line = Line {
            number: 1,
            indent: 0,
            text: Vec::new(),
        };
        Self {
            line,
            after_return: false,
        }
    }

    /// The line so far.
    pub fn line(&self) -> &Line {
        &self.line
    }

    /// Goes over blank lines and the indent of the next text; returns the bytes gone over.
    pub fn skip_blank(&mut self, bytes: &[u8]) -> usize {
        if !self.line.text.is_empty() {
            return 0;
        }
        let blank = bytes.iter().take_while(|byte| is_blank(**byte)).count();
        for &byte in &bytes[..blank] {
            self.go_over(byte);
        }
        blank
    }

    /// Takes the text up to the end of its line; returns the bytes taken, and the line if its
    /// end was there.
    pub fn take(&mut self, bytes: &[u8]) -> (usize, Option<Line>) {
        let end = bytes.iter().position(|byte| matches!(byte, b'\n' | b'\r'));
        let taken = end.unwrap_or(bytes.len());
        self.line.text.extend_from_slice(&bytes[..taken]);
        (taken, end.map(|_| self.end()))
    }

    /// The line as it is at the end of the file.
    pub fn end(&mut self) -> Line {
        let text = core::mem::take(&mut self.line.text);
        Line {
            text: text.trim_ascii_end().to_vec(),
            ..self.line
        }
    }

    fn go_over(&mut self, byte: u8) {
        match byte {
            b'\n' if self.after_return => {}
            b'\n' | b'\r' => {
                self.line.number += 1;
                self.line.indent = 0;
            }
            _ => self.line.indent += 1,
        }
        self.after_return = byte == b'\r';
    }
}

/// White space, and the control characters that some tools leave at the end of a file.
pub fn is_blank(byte: u8) -> bool {
    byte <= b' '
}
