//! How distances of all pairs are spread: distances go in; the largest, and the one at which a legend
//! of colours ends, come out. Two looks at every pair for the first sixteen bits and the rest, and no
//! sorted copy: ten thousand items have fifty million pairs.

use crate::distances::Distances;

/// Of the pairs, those that are within the legend: SHOWN's 98.5th percentile.
const WITHIN_LEGEND: f64 = 0.985;

/// Bits of a number that one look tells, from the highest.
const BITS: [u32; 3] = [20, 22, 22];

/// What is known of the distances of all pairs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spread {
    /// The largest distance.
    pub maximum: f64,
    /// The smallest distance that at least 98.5 % of the pairs do not exceed.
    pub legend_maximum: f64,
}

/// [`Spread`] in pieces. A number that is not negative is ordered as its bits are: each look counts the
/// pairs by some bits more, among those that share the bits known.
#[derive(Clone, Debug)]
pub struct SpreadRun {
    maximum: f64,
    /// Bits known, and how many.
    known: u64,
    known_bits: u32,
    /// How many of the pairs with those bits are not above the one looked for, which is counted too.
    rank: usize,
    counts: Vec<u32>,
    look: usize,
    row: usize,
}

impl SpreadRun {
    /// A run over these distances.
    pub fn new(distances: &Distances) -> Self {
        let rank = (WITHIN_LEGEND * distances.pairs() as f64).ceil() as usize;
        Self {
            maximum: 0.0,
            known: 0,
            known_bits: 0,
            rank: rank.max(1),
            counts: vec![0; 1 << BITS[0]],
            look: 0,
            row: 0,
        }
    }

    /// Looks at about `pairs` pairs more. Returns the part done, 1 when all is known.
    pub fn step(&mut self, distances: &Distances, pairs: usize) -> f64 {
        let rows = distances.items().saturating_sub(1);
        let mut left = pairs;
        while self.look < BITS.len() && left > 0 {
            if self.row == rows {
                self.end_look();
                continue;
            }
            let row = distances.to_later(self.row);
            left = left.saturating_sub(row.len());
            self.add(&row);
            self.row += 1;
        }
        let part = self.row as f64 / rows.max(1) as f64;
        ((self.look as f64 + part) / BITS.len() as f64).min(1.0)
    }

    /// What was found.
    pub fn finish(self) -> Spread {
        Spread {
            maximum: self.maximum,
            legend_maximum: f64::from_bits(self.known),
        }
    }

    fn add(&mut self, row: &[f64]) {
        let shift = 64 - self.known_bits - BITS[self.look];
        let mask = (1_u64 << BITS[self.look]) - 1;
        for &value in row {
            self.maximum = self.maximum.max(value);
            let bits = value.to_bits();
            // A shift by all bits is none at the first look, where nothing is known.
            let is_alike = self.known_bits == 0 || bits >> (64 - self.known_bits) == self.known;
            if is_alike {
                self.counts[(bits >> shift & mask) as usize] += 1;
            }
        }
    }

    /// Finds the next bits of the one looked for, and makes ready to look among those that share them.
    fn end_look(&mut self) {
        let mut next = 0;
        for (bits, &count) in self.counts.iter().enumerate() {
            if self.rank <= count as usize {
                next = bits as u64;
                break;
            }
            self.rank -= count as usize;
        }
        self.known = self.known << BITS[self.look] | next;
        self.known_bits += BITS[self.look];
        self.look += 1;
        self.row = 0;
        self.counts = match BITS.get(self.look) {
            Some(bits) => vec![0; 1 << bits],
            None => Vec::new(),
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::condensed::Condensed;

    fn found(items: usize, values: Vec<f64>) -> Spread {
        let distances = Distances::Stored(Condensed { items, values });
        let mut run = SpreadRun::new(&distances);
        while run.step(&distances, 7) < 1.0 {}
        run.finish()
    }

    #[test]
    fn the_legend_ends_where_a_sorted_list_says() {
        for items in [2, 3, 20, 60] {
            let count = items * (items - 1) / 2;
            let value = |index: usize| libm::fabs(libm::sin(index as f64 * 12.9898)) * 0.1;
            let values: Vec<f64> = (0..count).map(value).collect();
            let mut sorted = values.clone();
            sorted.sort_by(f64::total_cmp);
            let at = (0.985 * count as f64).ceil() as usize - 1;
            let expected = Spread {
                maximum: sorted[count - 1],
                legend_maximum: sorted[at],
            };
            assert_eq!(found(items, values), expected, "{items}");
        }
    }

    #[test]
    fn equal_pairs_and_no_pairs_have_an_end() {
        let same = Spread {
            maximum: 0.25,
            legend_maximum: 0.25,
        };
        assert_eq!(found(4, vec![0.25; 6]), same);
        assert_eq!(found(3, vec![0.0; 3]), Spread::default());
        assert_eq!(found(1, Vec::new()), Spread::default());
    }
}
