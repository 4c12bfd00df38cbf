//! Lines: slices cut anywhere go in, one whole line after the other comes out, with its place.

use super::place::{Place, is_blank};

/// A line without its indent.
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

    /// Splits off what begins at a byte of the text, all before being ASCII.
    pub fn split_off(&mut self, at: usize) -> Line {
        Line {
            number: self.number,
            indent: self.indent + at,
            text: self.text.split_off(at),
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

    /// Takes text up to the end of its line, at most `most` bytes; returns the bytes taken, and
    /// the line if its end is there.
    pub fn take(&mut self, bytes: &[u8], most: usize) -> (usize, Option<Line>) {
        let near = &bytes[..bytes.len().min(most)];
        let end = near.iter().position(|byte| matches!(byte, b'\n' | b'\r'));
        let taken = end.unwrap_or(near.len());
        self.after_return &= taken == 0;
        self.line.text.extend_from_slice(&near[..taken]);
        (taken, end.map(|_| self.end()))
    }

    /// The line as it is when its end, or that of the file, comes.
    pub fn end(&mut self) -> Line {
        let text = core::mem::take(&mut self.line.text);
        Line { text, ..self.line }
    }

    fn go_over(&mut self, byte: u8) {
        match byte {
            b'\n' if self.after_return => self.line.indent = 0,
            b'\n' | b'\r' => {
                self.line.number += 1;
                self.line.indent = 0;
            }
            _ => self.line.indent += 1,
        }
        self.after_return = byte == b'\r';
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(text: &[u8], slice: usize) -> Vec<(usize, usize, String)> {
        let mut lines = Lines::new();
        let mut found = Vec::new();
        for bytes in text.chunks(slice) {
            let mut rest = bytes;
            while !rest.is_empty() {
                rest = &rest[lines.skip_blank(rest)..];
                let (taken, line) = lines.take(rest, usize::MAX);
                found.extend(line);
                rest = &rest[taken..];
            }
        }
        found.push(lines.end());
        let shown = |line: Line| {
            (
                line.number,
                line.indent,
                String::from_utf8(line.text).unwrap(),
            )
        };
        found.into_iter().map(shown).collect()
    }

    #[test]
    fn lines_are_the_same_however_they_are_cut() {
        let text = b"a b\r\n\r\n\t c\rd\n\n  e";
        let expected = [(1, 0, "a b"), (3, 2, "c"), (4, 0, "d"), (6, 2, "e")];
        for slice in 1..=text.len() {
            let found = lines(text, slice);
            let found: Vec<_> = found
                .iter()
                .map(|line| (line.0, line.1, line.2.as_str()))
                .collect();
            assert_eq!(found, expected, "slices of {slice}");
        }
    }
}
