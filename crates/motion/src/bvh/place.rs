//! Places in a file: bytes gone over go in, lines and columns come out, worked out only when asked.

/// A place in a file; line and column count from 1, the column in characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// The line.
    pub line: usize,
    /// The column.
    pub column: usize,
}

/// The line that is being read, in slices.
///
/// Columns are counted in bytes: whatever is not ASCII in the rows is the first thing wrong in
/// its line.
#[derive(Clone, Copy, Debug)]
pub struct Position {
    line: usize,
    /// Where the line begins, counted from the beginning of the slice.
    line_start: i64,
    after_return: bool,
}

impl Position {
    /// In a line of which some characters are gone over.
    pub fn new(line: usize, characters_before: usize) -> Self {
        Self {
            line,
            line_start: -(characters_before as i64),
            after_return: false,
        }
    }

    /// The place of the byte `at` of the slice.
    pub fn place(&self, at: usize) -> Place {
        Place {
            line: self.line,
            column: (at as i64 - self.line_start) as usize + 1,
        }
    }

    /// Goes over the end of a line, `\n`, `\r` or both, at `at`.
    pub fn end_line(&mut self, byte: u8, at: usize) {
        let is_second_half = byte == b'\n' && self.after_return && self.place(at).column == 1;
        self.after_return = byte == b'\r';
        self.line += usize::from(!is_second_half);
        self.line_start = at as i64 + 1;
    }

    /// Goes on to the next slice.
    pub fn end_slice(&mut self, length: usize) {
        self.line_start -= length as i64;
    }
}

/// White space, and the control characters that some tools leave at the end of a file.
pub fn is_blank(byte: u8) -> bool {
    byte <= b' '
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_end_with_either_or_both() {
        let text = b"a\r\nb\rc\n\n\rd";
        for slice in 1..=text.len() {
            let mut position = Position::new(1, 0);
            let mut places = Vec::new();
            for bytes in text.chunks(slice) {
                for (at, &byte) in bytes.iter().enumerate() {
                    match byte {
                        b'\n' | b'\r' => position.end_line(byte, at),
                        _ => places.push(position.place(at).line),
                    }
                }
                position.end_slice(bytes.len());
            }
            assert_eq!(places, [1, 2, 3, 6], "slices of {slice}");
        }
    }
}
