//! How distances of all pairs are spread: distances go in; the largest, the one at which a legend of
//! colours ends, and the nearest of each item come out. Three looks at every pair tell twenty bits of
//! the legend's end each, and need no sorted copy: ten thousand items have fifty million pairs.

use crate::distances::Distances;

/// Of the pairs, those that are within the legend: SHOWN's 98.5th percentile.
const WITHIN_LEGEND: f64 = 0.985;

/// Bits of a number that one look tells, from the highest.
const BITS: [u32; 3] = [20, 22, 22];

/// What is known of the distances of all pairs.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Spread {
    /// The largest distance.
    pub maximum: f64,
    /// The smallest distance that at least 98.5 % of the pairs do not exceed.
    pub legend_maximum: f64,
    /// The item nearest to each, of equals the first; none without another.
    pub nearest: Vec<Option<usize>>,
    /// How far it is; infinite without another.
    pub nearest_distances: Vec<f64>,
}

/// [`Spread`] in pieces. A number that is not negative is ordered as its bits are: each look counts the
/// pairs by some bits more, among those that share the bits known.
#[derive(Clone, Debug)]
pub struct SpreadRun {
    maximum: f64,
    nearest: Vec<Option<usize>>,
    nearest_distances: Vec<f64>,
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
            nearest: vec![None; distances.items()],
            nearest_distances: vec![f64::INFINITY; distances.items()],
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
            if self.look == 0 {
                self.look_for_nearest(&row);
            }
            self.count(&row);
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
            nearest: self.nearest,
            nearest_distances: self.nearest_distances,
        }
    }

    /// Each item meets the others in their order, so that the first of equals stays.
    fn look_for_nearest(&mut self, row: &[f64]) {
        let one = self.row;
        for (other, &value) in (one + 1..).zip(row) {
            self.maximum = self.maximum.max(value);
            for (item, near) in [(one, other), (other, one)] {
                if value < self.nearest_distances[item] {
                    self.nearest_distances[item] = value;
                    self.nearest[item] = Some(near);
                }
            }
        }
    }

    fn count(&mut self, row: &[f64]) {
        let shift = 64 - self.known_bits - BITS[self.look];
        let mask = (1_u64 << BITS[self.look]) - 1;
        for &value in row {
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

    fn found(places: &[f64]) -> Spread {
        let distances = Distances::on_a_line(places);
        let mut run = SpreadRun::new(&distances);
        while run.step(&distances, 7) < 1.0 {}
        run.finish()
    }

    #[test]
    fn the_legend_ends_where_a_sorted_list_says() {
        for items in [2, 3, 20, 60] {
            let place = |index: usize| libm::sin(index as f64 * 12.9898) * 0.1;
            let places: Vec<f64> = (0..items).map(place).collect();
            let mut sorted = Distances::on_a_line(&places).condensed();
            sorted.sort_by(f64::total_cmp);
            let at = (0.985 * sorted.len() as f64).ceil() as usize - 1;
            let found = found(&places);
            assert_eq!(Some(&found.maximum), sorted.last(), "{items}");
            assert_eq!(found.legend_maximum, sorted[at], "{items}");
        }
    }

    #[test]
    fn equal_pairs_and_no_pairs_have_an_end() {
        let two = found(&[1.0, 1.25]);
        assert_eq!((two.maximum, two.legend_maximum), (0.25, 0.25));
        let same = found(&[7.0; 4]);
        assert_eq!(same.nearest, [Some(1), Some(0), Some(0), Some(0)]);
        assert_eq!(same.legend_maximum, 0.0);
        let one = found(&[5.0]);
        assert_eq!((one.legend_maximum, one.nearest), (0.0, vec![None]));
    }

    #[test]
    fn the_nearest_of_each_item_by_hand() {
        let line = found(&[0.0, 1.0, 3.0, 7.0]);
        assert_eq!(line.nearest, [Some(1), Some(0), Some(1), Some(2)]);
        assert_eq!(line.nearest_distances, [1.0, 1.0, 2.0, 4.0]);
    }
}
