//! The marks of a block go in; the words that end in it come out, if all of them are short numbers:
//! digits with or without a point, a minus before them or none.

use super::marks::{BLOCK, Marks};
use crate::bvh::number::{EvenWord, MOST_EVEN_DECIMALS, ShortWord};

/// The words of a block, its first byte being the first of a word or a blank.
#[derive(Clone, Copy, Debug)]
pub struct Words {
    /// First bytes.
    begins: u64,
    /// The blanks behind the last bytes.
    ends: u64,
    points: u64,
    minuses: u64,
    line_ends: u64,
    /// Where eight bytes of a word stand side by side.
    eights: u64,
}

impl Words {
    /// Of a block, at least one of them; none if one is anything but a number of at most 15
    /// bytes, sign included, of which a point is one at most and a digit one at least.
    #[inline]
    pub fn of(marks: &Marks) -> Option<Self> {
        let ends = marks.blanks & !marks.blanks << 1;
        let last = (1 << (BLOCK as u32 - 1 - (ends | 1).leading_zeros())) - 1;
        let words = !marks.blanks & last;
        let begins = words & !(words << 1);
        let digits = words & marks.digits;
        let points = words & marks.points;
        let others = words & !digits & !points & !(marks.minuses & begins);
        // Added to the first byte of a word, what is no point carries up to the first point.
        let first_points = begins.wrapping_add(words & !points);
        let without_digit = begins.wrapping_add(words & !digits) & marks.blanks;
        let eights = eights(words);
        let long = eights & eights >> 8;
        let odd = others | (points & !first_points) | without_digit | long;
        (ends != 0 && odd == 0).then_some(Self {
            begins,
            ends,
            points,
            minuses: marks.minuses,
            line_ends: marks.line_ends & (last << 1 | 1),
            eights,
        })
    }

    /// How many there are.
    #[inline]
    pub fn count(&self) -> usize {
        self.ends.count_ones() as usize
    }

    /// The number of decimals, if it is the same of all words and they can be read as even ones:
    /// with their points, of nine bytes at most.
    #[inline]
    pub fn even_decimals(&self) -> Option<usize> {
        let first_end = self.ends.trailing_zeros();
        let from_point = first_end.wrapping_sub(self.points.trailing_zeros());
        let decimals = (from_point as usize).wrapping_sub(1);
        let has_decimals = decimals.wrapping_sub(1) < MOST_EVEN_DECIMALS;
        let is_even = self.points == self.ends >> (from_point & 63);
        let is_long = self.eights & self.eights >> 2 != 0;
        (has_decimals && is_even && !is_long).then_some(decimals)
    }

    /// Those that are no longer in `rest`, which some were taken off.
    #[inline]
    pub fn before(&self, rest: &Self) -> Self {
        let ends = self.ends & !rest.ends;
        let length = BLOCK as u32 - ends.leading_zeros();
        Self {
            ends,
            line_ends: self.line_ends & (u64::MAX >> (BLOCK as u32 - length)),
            ..*self
        }
    }

    /// Bytes up to the blank behind the last one, with it.
    #[inline]
    pub fn length(&self) -> usize {
        BLOCK - self.ends.leading_zeros() as usize
    }

    /// For each line end the words before it, and its byte.
    pub fn lines(&self) -> impl Iterator<Item = (usize, usize)> {
        let (mut ends, mut line_ends) = (self.ends, self.line_ends);
        core::iter::from_fn(move || {
            let end = (line_ends != 0).then_some(line_ends.trailing_zeros())?;
            let gone_over = u64::MAX >> (BLOCK as u32 - 1 - end);
            let count = (ends & gone_over).count_ones();
            ends &= !gone_over;
            line_ends &= !gone_over;
            Some((count as usize, end as usize))
        })
    }

    /// Takes the first eight off, all being even; those after the last one are without meaning.
    #[inline]
    pub fn take_eight(&mut self) -> [EvenWord; 8] {
        let mut start = 0;
        [(); 8].map(|()| {
            let end = self.ends.trailing_zeros() as usize;
            self.ends &= self.ends.wrapping_sub(1);
            let length = end.wrapping_sub(start);
            start = end + 1;
            EvenWord { end, length }
        })
    }

    /// Takes the next one off; after the last one, a word without meaning.
    #[inline]
    pub fn take(&mut self) -> ShortWord {
        let begin = self.begins.trailing_zeros() & 63;
        let end = self.ends.trailing_zeros() & 63;
        self.begins &= self.begins.wrapping_sub(1);
        self.ends &= self.ends.wrapping_sub(1);
        let is_negative = self.minuses >> begin & 1;
        let begin = (begin + is_negative as u32) & 63;
        let length = end.wrapping_sub(begin) & 15;
        let point = (self.points >> begin | 1 << length).trailing_zeros();
        ShortWord {
            end: end as usize,
            shape: (length << 4 | point) as usize,
            sign: is_negative << 63,
        }
    }
}

/// Where eight bytes stand side by side: a bit where they begin.
fn eights(words: u64) -> u64 {
    let pairs = words & words >> 1;
    let fours = pairs & pairs >> 2;
    fours & fours >> 4
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> Option<Words> {
        let mut block = [b' '; BLOCK];
        block[..text.len()].copy_from_slice(text.as_bytes());
        Words::of(&Marks::of(&block))
    }

    fn length_and_point(word: ShortWord) -> (usize, usize) {
        (word.shape >> 4, word.shape & 15)
    }

    #[test]
    fn short_numbers_are_taken_in_order() {
        let mut words = words("1.25  -7\t.5 -12345678901234 00.").expect("numbers");
        assert_eq!((words.count(), words.length()), (5, 32));
        let taken: Vec<_> = (0..5).map(|_| words.take()).collect();
        let ends: Vec<_> = taken.iter().map(|word| word.end).collect();
        assert_eq!(ends, [4, 8, 11, 27, 31]);
        let shapes: Vec<_> = taken.into_iter().map(length_and_point).collect();
        assert_eq!(shapes, [(4, 1), (1, 1), (2, 0), (14, 14), (3, 2)]);
    }

    #[test]
    fn a_word_that_goes_on_behind_the_block_is_left() {
        let text = format!("{:56}1.5 1e99", "2");
        let words = words(&text).expect("numbers");
        assert_eq!((words.count(), words.length()), (2, 60));
        assert!(Words::of(&Marks::of(&[b'1'; BLOCK])).is_none());
    }

    #[test]
    fn anything_else_is_no_words() {
        for text in [
            "",
            "x",
            "1 - 2",
            "-",
            ".",
            "-.",
            "1.2.3",
            "1-2",
            "--1",
            "+1",
            "1e5",
            "1,5",
            "nan",
            "1 2 1.2. 3",
            "1234567890123456",
            "-123456789012345",
        ] {
            assert!(words(text).is_none(), "{text}");
        }
    }

    #[test]
    fn lines_end_with_their_words() {
        let found = words("1 2\n\r 3 \n4").expect("numbers");
        assert_eq!(found.lines().collect::<Vec<_>>(), [(2, 3), (0, 4), (1, 8)]);
    }

    #[test]
    fn words_are_even_where_their_points_stand_as_far_from_their_ends() {
        let decimals = |text| words(text).and_then(|words| words.even_decimals());
        assert_eq!(decimals("1.25 -7.50  .00 123456.78"), Some(2));
        assert_eq!(decimals("1.2345678 "), Some(7));
        for text in [
            "1 2",
            "1. 2.",
            "1.25 7.5",
            "1.25 7",
            "1.2.4 6",
            "1.25 7.500",
            "12345678 1.2",
            "123456789.5",
            "-12345678.5",
            "1.23456789",
        ] {
            assert_eq!(decimals(text), None, "{text}");
        }
    }
}
