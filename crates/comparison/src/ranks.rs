//! Where a pair stands among all: distances and two items in, their ranks out. Every pair is looked at,
//! in pieces.

use crate::distances::Distances;

/// Places of a pair, from 1, the most alike first; of equals all have the best.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ranks {
    /// Among all pairs.
    pub of_all: usize,
    /// Of the second among the neighbours of the first.
    pub from_a: usize,
    /// Of the first among the neighbours of the second.
    pub from_b: usize,
}

/// [`Ranks`] in pieces. Every call takes the same distances.
#[derive(Clone, Debug)]
pub struct RanksRun {
    value: f64,
    /// So far, one for each nearer pair found.
    ranks: Ranks,
    row: usize,
}

impl RanksRun {
    /// The ranks of two different items; how they stand as neighbours is known at once.
    #[must_use]
    pub fn new(distances: &Distances, a: usize, b: usize) -> Self {
        let value = distances.at(a, b);
        let rank_from = |item: usize| {
            let row = distances.row(item);
            let others = row[..item].iter().chain(&row[item + 1..]);
            1 + count_below(value, others)
        };
        Self {
            value,
            ranks: Ranks {
                of_all: 1,
                from_a: rank_from(a),
                from_b: rank_from(b),
            },
            row: 0,
        }
    }

    /// Looks at about `pairs` pairs more. Returns the part done, 1 when all have been.
    pub fn step(&mut self, distances: &Distances, pairs: usize) -> f64 {
        let rows = distances.items().saturating_sub(1);
        let mut left = pairs.max(1);
        while self.row < rows && left > 0 {
            let row = distances.to_later(self.row);
            self.ranks.of_all += count_below(self.value, &row);
            left = left.saturating_sub(row.len());
            self.row += 1;
        }
        distances.part_of_rows(self.row)
    }

    /// The ranks, once all pairs have been looked at.
    #[must_use]
    pub fn finish(self) -> Ranks {
        self.ranks
    }
}

fn count_below<'a>(value: f64, distances: impl IntoIterator<Item = &'a f64>) -> usize {
    let nearer = distances.into_iter().filter(|other| **other < value);
    nearer.count()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ranks(places: &[f64], a: usize, b: usize, pairs: usize) -> Ranks {
        let distances = Distances::on_a_line(places);
        let mut run = RanksRun::new(&distances, a, b);
        while run.step(&distances, pairs) < 1.0 {}
        run.finish()
    }

    #[test]
    fn ranks_by_hand() {
        // Distances: 1 3 7, 2 6, 4.
        let places = [0.0, 1.0, 3.0, 7.0];
        for pairs in [1, 100] {
            let found = ranks(&places, 1, 2, pairs);
            assert_eq!((found.of_all, found.from_a, found.from_b), (2, 2, 1));
            let found = ranks(&places, 3, 0, pairs);
            assert_eq!((found.of_all, found.from_a, found.from_b), (6, 3, 3));
        }
    }

    #[test]
    fn equal_pairs_have_the_best_rank() {
        // Two pairs at 0, four at 5.
        let found = ranks(&[0.0, 0.0, 5.0, 5.0], 0, 3, 2);
        assert_eq!((found.of_all, found.from_a, found.from_b), (3, 2, 2));
    }
}
