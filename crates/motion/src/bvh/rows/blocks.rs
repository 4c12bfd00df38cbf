//! Rows of the plain shape, nearly all of a file: blocks of 64 bytes go in, values come out.
//!
//! Where words and lines end is found for a whole block first, so that no number has to wait for
//! the one before it (G. Langdale, D. Lemire, *Parsing gigabytes of JSON per second*, The VLDB
//! Journal 28, 2019). Whatever is not plain is left as it is, from the block in which it begins.

use super::Rows;
use super::layout::Layout;
use super::marks::{BLOCK, Marks};
use crate::bvh::number::{self, Mark};
use crate::bvh::place::Position;

/// The words of one block, each a bit.
struct Words {
    /// First bytes.
    begins: u64,
    /// The blanks behind the last bytes.
    ends: u64,
    line_ends: u64,
}

/// How far the blocks have come.
struct Cursor {
    /// The next block.
    at: usize,
    /// Where a word that has not ended begins.
    open_word: Option<usize>,
}

impl Cursor {
    fn unread(&self) -> usize {
        self.open_word.unwrap_or(self.at)
    }

    fn words(&self, block: &[u8; BLOCK]) -> Words {
        let Marks { blanks, line_ends } = Marks::of(block);
        let words = !blanks;
        let after_word = words << 1 | u64::from(self.open_word.is_some());
        Words {
            begins: words & !after_word,
            ends: blanks & after_word,
            line_ends,
        }
    }
}

impl Rows {
    /// Reads blocks while all in them is plain; returns where the rest begins.
    pub(super) fn plain_blocks(&mut self, bytes: &[u8], start: usize) -> usize {
        let mut cursor = Cursor {
            at: start,
            open_word: None,
        };
        let is_plain = matches!(self.layout, Layout::Frames(None));
        if !is_plain || self.known.mark != Some(Mark::Point) {
            return start;
        }
        while let Some(block) = bytes[cursor.at..].first_chunk() {
            let words = cursor.words(block);
            let lines = self.lines(block, &words, cursor.at);
            let Some((in_line, position)) = lines else {
                break;
            };
            let Some(open_word) = self.numbers(bytes, &words, &cursor) else {
                break;
            };
            (self.in_line, self.position) = (in_line, position);
            cursor = Cursor {
                at: cursor.at + BLOCK,
                open_word,
            };
        }
        cursor.unread()
    }

    /// The values in the last line and its position, if all lines that end in a block are whole.
    fn lines(&self, block: &[u8; BLOCK], words: &Words, at: usize) -> Option<(usize, Position)> {
        let (mut ends, mut line_ends) = (words.ends, words.line_ends);
        let (mut in_line, mut position) = (self.in_line, self.position);
        while line_ends != 0 {
            let end = line_ends.trailing_zeros();
            let byte = block[end as usize];
            let gone_over = u64::MAX >> (BLOCK as u32 - 1 - end);
            in_line += (ends & gone_over).count_ones() as usize;
            if (in_line != 0 && in_line != self.width) || !matches!(byte, b'\n' | b'\r') {
                return None;
            }
            in_line = 0;
            position.end_line(byte, at + end as usize);
            ends &= !gone_over;
            line_ends &= line_ends - 1;
        }
        in_line += ends.count_ones() as usize;
        (in_line <= self.width).then_some((in_line, position))
    }

    /// Reads the words that end in a block, if all are plain numbers and there is room for them;
    /// returns where the word begins that does not end in it.
    fn numbers(&mut self, bytes: &[u8], words: &Words, cursor: &Cursor) -> Option<Option<usize>> {
        let length = self.values.len();
        let count = words.ends.count_ones() as usize;
        if self.values.capacity() - length < count {
            return None;
        }
        let (mut begins, mut ends) = (words.begins, words.ends);
        let mut open_word = cursor.open_word;
        let mut are_numbers = true;
        self.values.extend((0..count).map(|_| {
            let start = open_word
                .take()
                .unwrap_or_else(|| next(&mut begins, cursor.at));
            let end = next(&mut ends, cursor.at);
            let value = number::between(bytes, start, end);
            are_numbers &= value.is_some();
            value.unwrap_or(0.0)
        }));
        if !are_numbers {
            self.values.truncate(length);
            return None;
        }
        Some(open_word.or((begins != 0).then(|| next(&mut begins, cursor.at))))
    }
}

/// Takes the lowest bit; the place that it stands for.
fn next(bits: &mut u64, at: usize) -> usize {
    let place = at + bits.trailing_zeros() as usize;
    *bits &= bits.wrapping_sub(1);
    place
}
