//! The nearest labelled item of each labelled one, in pieces: distances, the nearest of all and labels
//! in, the classification out. An item whose nearest of all has a label needs no second look.

use super::OneNearest;
use crate::distances::Distances;
use crate::spread::Spread;

/// [`OneNearest`] in pieces. Every call takes the same distances.
#[derive(Clone, Debug, Default)]
pub struct OneNearestRun {
    labels: Vec<Option<usize>>,
    /// Of the items looked at.
    nearest: Vec<Option<usize>>,
}

impl OneNearestRun {
    /// Classifies items by one label each, or none.
    #[must_use]
    pub fn new(labels: Vec<Option<usize>>) -> Self {
        let nearest = Vec::with_capacity(labels.len());
        Self { labels, nearest }
    }

    /// Looks at about `pairs` pairs more. Returns the part done, 1 when all is known.
    pub fn step(&mut self, distances: &Distances, spread: &Spread, pairs: usize) -> f64 {
        let items = self.labels.len();
        let mut left = pairs.max(1);
        while self.nearest.len() < items && left > 0 {
            let item = self.nearest.len();
            let of_all = spread.nearest[item];
            let is_known = self.labels[item].is_none()
                || of_all.is_none_or(|nearest| self.labels[nearest].is_some());
            self.nearest.push(match is_known {
                true => of_all.filter(|_| self.labels[item].is_some()),
                false => self.nearest_labelled(distances, item),
            });
            left = left.saturating_sub(if is_known { 1 } else { items });
        }
        match items {
            0 => 1.0,
            _ => self.nearest.len() as f64 / items as f64,
        }
    }

    /// The classification, once all is known.
    #[must_use]
    pub fn finish(self) -> OneNearest {
        OneNearest::of(&self.labels, self.nearest)
    }

    /// Of equals the first.
    fn nearest_labelled(&self, distances: &Distances, item: usize) -> Option<usize> {
        let row = distances.row(item);
        let others = (0..row.len()).filter(|other| *other != item);
        others
            .filter(|other| self.labels[*other].is_some())
            .min_by(|one, other| row[*one].total_cmp(&row[*other]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluation::leave_one_out;
    use crate::feature::Vector;
    use crate::spread::SpreadRun;
    use test_support::Random;

    fn spread_of(distances: &Distances) -> Spread {
        let mut run = SpreadRun::new(distances);
        while run.step(distances, usize::MAX) < 1.0 {}
        run.finish()
    }

    /// Vectors of few values, so that many are as near.
    fn vectors(count: usize, random: &mut Random) -> Vec<Vector> {
        let mut vector = || std::array::from_fn(|_| (2.0 * random.unit()).round());
        (0..count).map(|_| vector()).collect()
    }

    #[test]
    fn pieces_find_what_all_pairs_tell() {
        let mut random = Random::new(3);
        for items in [0, 1, 2, 40] {
            for part_with_label in [0.0, 0.1, 0.5, 1.0] {
                let distances = Distances::of_vectors(vectors(items, &mut random), false);
                let label =
                    |value: f64| (value < part_with_label).then_some((value * 30.0) as usize);
                let labels: Vec<_> = (0..items).map(|_| label(random.unit())).collect();
                let mut run = OneNearestRun::new(labels.clone());
                let spread = spread_of(&distances);
                while run.step(&distances, &spread, 3) < 1.0 {}
                let expected = leave_one_out(&labels, |a, b| distances.at(a, b));
                assert_eq!(run.finish(), expected, "{items} {part_with_label}");
            }
        }
    }
}
