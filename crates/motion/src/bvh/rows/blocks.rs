//! Rows of the plain shape, nearly all of a file: blocks of 64 bytes go in, values come out.
//!
//! Where words and lines end is found for a whole block first, so that no number has to wait for
//! the one before it (G. Langdale, D. Lemire, *Parsing gigabytes of JSON per second*, The VLDB
//! Journal 28, 2019). A block that is not plain is left, with all that follows.

use super::Rows;
use super::layout::Layout;
use super::marks::{BLOCK, Marks};
use super::words::Words;
use crate::bvh::number::{self, Even, Mark, WINDOW};

/// Bytes before a block that its first word may need.
const BEFORE: usize = WINDOW - BLOCK;

/// Most words of a block, and one more to make them even.
const MOST_WORDS: usize = BLOCK / 2 + 1;

/// Most words of a block of which only the first eight are read at once.
const MOST_EVEN: usize = 14;

/// Values on their way to those of all rows, to which adding a few at a time is slow.
struct Batch {
    values: [f64; Self::LENGTH],
    count: usize,
}

impl Batch {
    const LENGTH: usize = 256;

    fn new() -> Self {
        Self {
            values: [0.0; Self::LENGTH],
            count: 0,
        }
    }

    /// Reads words behind the values that count; returns them.
    fn place(&mut self, window: &[u8; WINDOW], words: Words) -> Words {
        let mut rest = words;
        let free = self.values[self.count..].as_chunks_mut().0;
        for pair in free.iter_mut().take(words.count().div_ceil(2)) {
            *pair = number::short_pair(window, [rest.take(), rest.take()]);
        }
        words
    }

    /// Reads the first eight words, or all, behind the values that count; returns them. Were it all
    /// of nine too, no processor could foresee how many come.
    #[inline]
    fn place_even(&mut self, window: &[u8; WINDOW], words: Words, even: Even) -> Words {
        let mut rest = words;
        let [a, b, c, d, e, f, g, h] = rest.take_eight();
        if let Some(free) = self.values[self.count..].first_chunk_mut::<8>() {
            free[..4].copy_from_slice(&even.four(window, [a, b, c, d]));
            free[4..].copy_from_slice(&even.four(window, [e, f, g, h]));
        }
        words.before(&rest)
    }

    fn has_room(&self) -> bool {
        self.count <= Self::LENGTH - MOST_WORDS
    }

    fn empty_into(&mut self, values: &mut Vec<f64>) {
        values.extend_from_slice(&self.values[..self.count]);
        self.count = 0;
    }
}

impl Rows {
    /// Reads blocks while all in them is plain; returns where the rest begins.
    pub(super) fn plain_blocks(&mut self, bytes: &[u8], start: usize) -> usize {
        let is_plain = matches!(self.layout, Layout::Frames(None));
        if !is_plain || self.known.mark != Some(Mark::Point) {
            return start;
        }
        let mut batch = Batch::new();
        let mut at = start;
        while let Some(length) = self.plain_block(bytes, at, &mut batch) {
            at += length;
            if !batch.has_room() {
                batch.empty_into(&mut self.values);
            }
        }
        batch.empty_into(&mut self.values);
        at
    }

    /// Reads the words that end in a block, if all are plain; returns the bytes that they take.
    #[inline]
    fn plain_block(&mut self, bytes: &[u8], at: usize, batch: &mut Batch) -> Option<usize> {
        let window: &[u8; WINDOW] = bytes.get(at.checked_sub(BEFORE)?..)?.first_chunk()?;
        let words = Words::of(&Marks::of(window.last_chunk()?))?;
        let free = self.values.capacity() - self.values.len() - batch.count;
        if free < words.count() {
            return None;
        }
        let taken = match words.even_decimals() {
            Some(decimals) if words.count() <= MOST_EVEN => {
                batch.place_even(window, words, Even::of(decimals))
            }
            _ => batch.place(window, words),
        };
        self.end_lines(bytes, at, &taken)?;
        batch.count += taken.count();
        Some(taken.length())
    }

    /// Goes over the lines of a block, if all that end in it are whole.
    #[inline]
    fn end_lines(&mut self, bytes: &[u8], at: usize, words: &Words) -> Option<()> {
        let (mut in_line, mut position) = (self.in_line, self.position);
        let mut left = words.count();
        for (count, end) in words.lines() {
            let byte = bytes[at + end];
            in_line += count;
            if (in_line != 0 && in_line != self.width) || !matches!(byte, b'\n' | b'\r') {
                return None;
            }
            in_line = 0;
            left -= count;
            position.end_line(byte, at + end);
        }
        if in_line + left > self.width {
            return None;
        }
        (self.in_line, self.position) = (in_line + left, position);
        Some(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use test_support::Random;

    /// What a block reads of a word that stands anywhere in it.
    fn read(word: &str, before: usize) -> Option<f64> {
        let mut window = [b' '; WINDOW];
        window[BEFORE + before..][..word.len()].copy_from_slice(word.as_bytes());
        let mut words = Words::of(&Marks::of(window.last_chunk()?))?;
        assert_eq!(words.count(), 1);
        Some(number::short_pair(&window, [words.take(), words.take()])[0])
    }

    /// Up to 14 digits, often few, with a point or without, and a sign.
    fn any_word(random: &mut Random) -> String {
        let most = [4, 9, 15][random.below(3)];
        let mut text: String = (0..1 + random.below(most - 1))
            .map(|_| char::from(b'0' + random.below(10) as u8))
            .collect();
        if text.len() < 14 && random.below(4) > 0 {
            text.insert(random.below(text.len() + 1), '.');
        }
        if text.len() < 15 && random.below(2) > 0 {
            text.insert(0, '-');
        }
        text
    }

    #[test]
    fn a_million_short_numbers_are_exact() {
        let mut random = Random::new(22);
        for _ in 0..1_000_000 {
            let word = any_word(&mut random);
            let found = read(&word, random.below(BLOCK - word.len()));
            let expected: f64 = word.parse().expect("a number");
            assert_eq!(found.map(f64::to_bits), Some(expected.to_bits()), "{word}");
        }
    }

    /// At most eight digits, with a sign seven, of which so many are decimals.
    fn even_word(random: &mut Random, decimals: usize) -> String {
        let sign = ["", "-"][random.below(2)];
        let whole = random.below(9 - decimals - sign.len());
        let mut digits = |count: usize| -> String {
            let digit = |_| char::from(b'0' + random.below(10) as u8);
            (0..count).map(digit).collect()
        };
        format!("{sign}{}.{}", digits(whole), digits(decimals))
    }

    /// A block full of such words, and the words.
    fn even_block(random: &mut Random, decimals: usize) -> (String, Vec<String>) {
        let (mut text, mut words) = (String::new(), Vec::new());
        loop {
            let blanks = " ".repeat(usize::from(!words.is_empty()) + random.below(2));
            let word = even_word(random, decimals);
            if text.len() + blanks.len() + word.len() >= BLOCK {
                return (text, words);
            }
            text += &blanks;
            text += &word;
            words.push(word);
        }
    }

    #[test]
    fn even_numbers_are_exact() {
        let mut random = Random::new(23);
        for _ in 0..20_000 {
            let decimals = 1 + random.below(7);
            let (text, expected) = even_block(&mut random, decimals);
            let mut window = [b'7'; WINDOW];
            window[BEFORE..].fill(b' ');
            window[BEFORE..][..text.len()].copy_from_slice(text.as_bytes());
            let mut batch = Batch::new();
            let words = Words::of(&Marks::of(window.last_chunk().unwrap())).expect("words");
            assert_eq!(words.even_decimals(), Some(decimals), "{text}");
            let taken = batch.place_even(&window, words, Even::of(decimals));
            assert_eq!(taken.count(), expected.len().min(8));
            for (found, word) in batch.values[..taken.count()].iter().zip(&expected) {
                let number: f64 = word.parse().expect("a number");
                assert_eq!(found.to_bits(), number.to_bits(), "{word} of {text}");
            }
            let length = text.len().min(taken.length());
            let gone_over = text[..length].split_whitespace();
            assert!(gone_over.eq(expected[..taken.count()].iter().map(String::as_str)));
        }
    }
}
