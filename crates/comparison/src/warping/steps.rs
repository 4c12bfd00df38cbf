//! The last step to every cell, two bits each: steps row by row in, the step of a cell out.

use super::band::Band;

/// Steps in one word.
const A_WORD: usize = 32;

/// How a path comes to a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// Both clips move on a frame.
    Both = 0,
    /// The first one does.
    A = 1,
    /// The second one does.
    B = 2,
}

/// The steps to all cells of a band; each row begins with a word of its own.
#[derive(Clone, Debug)]
pub struct Steps {
    words: Vec<u64>,
    /// The first word of each row.
    starts: Vec<usize>,
}

impl Steps {
    /// Room for a band.
    pub fn new(band: &Band) -> Self {
        let mut end = 0;
        let start = |row| {
            let start = end;
            end += band.row(row).len().div_ceil(A_WORD);
            start
        };
        let starts = (0..band.rows()).map(start).collect();
        Self {
            words: vec![0; end],
            starts,
        }
    }

    /// Where the steps of a row go, from its first cell on.
    pub fn row(&mut self, row: usize) -> RowSteps<'_> {
        RowSteps {
            words: self.words[self.starts[row]..].iter_mut(),
            word: 0,
            count: 0,
        }
    }

    /// The step to the cell of frames `a` and `b`, which lies in the band.
    pub fn at(&self, a: usize, b: usize, band: &Band) -> Step {
        let place = b.saturating_sub(band.row(a).start);
        let word = self.words[self.starts[a] + place / A_WORD];
        match (word >> (2 * (place % A_WORD))) & 3 {
            0 => Step::Both,
            1 => Step::A,
            _ => Step::B,
        }
    }
}

/// The steps of one row while they come in.
#[derive(Debug)]
pub struct RowSteps<'a> {
    words: core::slice::IterMut<'a, u64>,
    word: u64,
    count: usize,
}

impl RowSteps<'_> {
    /// The step to the next cell.
    pub fn push(&mut self, step: Step) {
        self.word |= (step as u64) << (2 * self.count);
        self.count += 1;
        if self.count == A_WORD {
            self.flush();
        }
    }

    /// Writes what is not written; needed after the last cell.
    pub fn flush(&mut self) {
        if self.count > 0
            && let Some(word) = self.words.next()
        {
            *word = self.word;
        }
        (self.word, self.count) = (0, 0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_come_back_in_and_without_a_band() {
        for width in [None, Some(40)] {
            let band = Band::new(50, 100, width);
            let step = |a: usize, b: usize| [Step::Both, Step::A, Step::B][(a * 7 + b * b) % 3];
            let mut steps = Steps::new(&band);
            for a in 0..50 {
                let mut row = steps.row(a);
                for b in band.row(a) {
                    row.push(step(a, b));
                }
                row.flush();
            }
            for (a, b) in (0..50).flat_map(|a| band.row(a).map(move |b| (a, b))) {
                assert_eq!(steps.at(a, b, &band), step(a, b));
            }
        }
    }
}
