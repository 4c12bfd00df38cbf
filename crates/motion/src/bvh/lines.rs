//! Lines: slices cut anywhere go in, one whole line after the other comes out, with its place.

use core::ops::Range;

use super::place::{Place, is_blank};

/// Bytes of the texts of a usual hierarchy.
const USUAL_BYTES: usize = 8 << 10;

/// Where a line begins, and its text, without its indent, among those of all lines.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line {
    /// The number, from 1.
    pub number: usize,
    /// White space before the text, in characters.
    pub indent: usize,
    /// The bytes of the text in [`Lines::texts`].
    pub text: Range<usize>,
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
        let start = self.text.start + at;
        Line {
            number: self.number,
            indent: self.indent + at,
            text: start..core::mem::replace(&mut self.text.end, start),
        }
    }
}

/// Puts lines together, the text of one behind that of the other: memory of its own for each would
/// take longer than all else.
#[derive(Debug)]
pub struct Lines {
    texts: Vec<u8>,
    /// Where the text of the line that is read begins.
    start: usize,
    number: usize,
    indent: usize,
    after_return: bool,
}

impl Lines {
    /// Before the first line.
    pub fn new() -> Self {
        Self {
            texts: Vec::with_capacity(USUAL_BYTES),
            start: 0,
            number: 1,
            indent: 0,
            after_return: false,
        }
    }

    /// The line so far.
    pub fn line(&self) -> Line {
        Line {
            number: self.number,
            indent: self.indent,
            text: self.start..self.texts.len(),
        }
    }

    /// The text of the line so far.
    pub fn text(&self) -> &[u8] {
        &self.texts[self.start..]
    }

    /// The texts of all lines, as bytes of the file, with a line feed between each two.
    pub fn texts(&self) -> &[u8] {
        &self.texts
    }

    /// Forgets the texts from that of a line on.
    pub fn forget(&mut self, line: &Line) {
        self.texts.truncate(line.text.start);
        self.start = self.texts.len();
    }

    /// Goes over blank lines and the indent of the next text; returns the bytes gone over.
    pub fn skip_blank(&mut self, bytes: &[u8]) -> usize {
        if !self.text().is_empty() {
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
        self.texts.extend_from_slice(&near[..taken]);
        (taken, end.map(|_| self.end()))
    }

    /// The line when its end, or that of the file, comes.
    pub fn end(&mut self) -> Line {
        let line = self.line();
        self.texts.push(b'\n');
        self.start = self.texts.len();
        line
    }

    fn go_over(&mut self, byte: u8) {
        match byte {
            b'\n' if self.after_return => self.indent = 0,
            b'\n' | b'\r' => {
                self.number += 1;
                self.indent = 0;
            }
            _ => self.indent += 1,
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
            let text = lines.texts()[line.text].to_vec();
            (line.number, line.indent, String::from_utf8(text).unwrap())
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

    #[test]
    fn a_line_is_split_and_forgotten() {
        let mut lines = Lines::new();
        lines.take(b"first\n", usize::MAX);
        lines.skip_blank(b"\n ");
        let mut line = lines.take(b"} second\n", usize::MAX).1.expect("a line");
        let rest = line.split_off(2);
        assert_eq!(&lines.texts()[line.text], b"} ");
        assert_eq!(&lines.texts()[rest.text.clone()], b"second");
        assert_eq!(rest.place(), Place { line: 2, column: 4 });
        lines.forget(&rest);
        assert_eq!((lines.texts(), lines.text()), (&b"first\n} "[..], &b""[..]));
    }
}
