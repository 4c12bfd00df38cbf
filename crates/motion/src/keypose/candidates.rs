//! Minima of a series: samples in, the indices of the minima that count out.
//!
//! A minimum is an interior sample lower than the one before and, after any plateau, followed by a
//! rise; a plateau counts once, at `⌊(first + last) / 2⌋`. Minima of less depth than a floor are
//! dropped by persistence: as long as a minimum lies less than that below the bump towards a
//! neighbour that is not higher (an end of the series counts as lower), the one with the least
//! such depth goes (of equals the later one) and its two bumps merge.
//!
//! What is left alternates: between two kept minima stands a bump at least the floor above both,
//! and each is the lowest, of equals the first, between its bumps. So one pass finds it.

/// The minima of `series` that are at least `floor` deep, in order.
pub fn minima(series: &[f64], floor: f64) -> Vec<usize> {
    let mut scan = Scan::new(floor);
    series.iter().for_each(|sample| scan.take(*sample));
    scan.finish()
}

/// [`minima`] while the samples come one by one.
#[derive(Clone, Debug)]
pub struct Scan {
    kept: Kept,
    /// Samples taken.
    count: usize,
    /// The last of them.
    value: f64,
    /// The highest since the last minimum.
    bump: f64,
    /// First index of the plateau that a fall has led to.
    valley: Option<usize>,
}

impl Scan {
    /// A scan for minima at least `floor` deep.
    pub fn new(floor: f64) -> Self {
        Self {
            kept: Kept::new(floor),
            count: 0,
            value: f64::NAN,
            bump: f64::NEG_INFINITY,
            valley: None,
        }
    }

    /// Takes the next sample.
    #[inline(always)]
    pub fn take(&mut self, next: f64) {
        if next < self.value {
            self.valley = Some(self.count);
        } else if next > self.value
            && let Some(first) = self.valley.take()
        {
            let middle = (first + self.count - 1) / 2;
            self.kept.minimum(middle, self.value, self.bump);
            self.bump = next;
        }
        self.bump = self.bump.max(next);
        self.value = next;
        self.count += 1;
    }

    /// The minima, in order.
    pub fn finish(self) -> Vec<usize> {
        self.kept.finish(self.bump)
    }
}

/// The minima kept so far, the last of them pending.
#[derive(Clone, Debug)]
struct Kept {
    floor: f64,
    sure: Vec<usize>,
    /// A minimum deep enough below the bump before it, with its value.
    pending: Option<(usize, f64)>,
    /// The highest bump since the pending minimum, or without one since the last sure one.
    bump: f64,
}

impl Kept {
    fn new(floor: f64) -> Self {
        Self {
            floor,
            sure: Vec::new(),
            pending: None,
            bump: f64::NEG_INFINITY,
        }
    }

    /// Takes the next minimum and the bump before it.
    fn minimum(&mut self, index: usize, value: f64, bump: f64) {
        self.bump = self.bump.max(bump);
        if let Some((_, lowest)) = self.pending {
            if self.bump - lowest >= self.floor {
                self.confirm();
            } else if value < lowest {
                self.pend(index, value);
            }
        }
        if self.pending.is_none() && self.bump - value >= self.floor {
            self.pend(index, value);
        }
    }

    fn pend(&mut self, index: usize, value: f64) {
        self.pending = Some((index, value));
        self.bump = f64::NEG_INFINITY;
    }

    fn confirm(&mut self) {
        self.sure
            .extend(self.pending.take().map(|(index, _)| index));
    }

    fn finish(mut self, bump: f64) -> Vec<usize> {
        self.bump = self.bump.max(bump);
        if self
            .pending
            .is_some_and(|(_, lowest)| self.bump - lowest >= self.floor)
        {
            self.confirm();
        }
        self.sure
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use test_support::Random;

    /// The rule as it is written: drop the shallowest, merge its bumps, look again.
    fn minima_by_dropping(series: &[f64], floor: f64) -> Vec<usize> {
        let mut kept = minima(series, 0.0);
        loop {
            let peak =
                |from: usize, to: usize| series[from..=to].iter().copied().fold(f64::MIN, f64::max);
            let depth = |place: usize| {
                let (at, left) = (kept[place], place.checked_sub(1).map(|left| kept[left]));
                let right = kept.get(place + 1).copied();
                let mut depth = f64::INFINITY;
                if left.is_none_or(|left| series[left] <= series[at]) {
                    depth = depth.min(peak(left.unwrap_or(0), at) - series[at]);
                }
                if right.is_none_or(|right| series[right] <= series[at]) {
                    depth = depth.min(peak(at, right.unwrap_or(series.len() - 1)) - series[at]);
                }
                depth
            };
            let shallowest = (0..kept.len())
                .map(|place| (depth(place), place))
                .filter(|&(depth, _)| depth < floor)
                .min_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
            match shallowest {
                Some((_, place)) => kept.remove(place),
                None => return kept,
            };
        }
    }

    #[test]
    fn plateaus_count_once_and_ends_never() {
        assert_eq!(minima(&[3.0, 1.0, 2.0], 0.0), [1]);
        assert_eq!(minima(&[3.0, 1.0, 1.0, 2.0], 0.0), [1]);
        assert_eq!(minima(&[3.0, 1.0, 1.0, 1.0, 2.0], 0.0), [2]);
        assert_eq!(minima(&[1.0, 2.0, 3.0, 2.0, 1.0], 0.0), [0; 0]);
        assert_eq!(minima(&[3.0, 1.0, 1.0], 0.0), [0; 0]);
        assert_eq!(minima(&[1.0, 1.0, 2.0], 0.0), [0; 0]);
        assert_eq!(minima(&[3.0, 2.0, 2.0, 1.0, 2.0], 0.0), [3]);
        assert_eq!(minima(&[], 0.0), [0; 0]);
        assert_eq!(minima(&[f64::NAN; 9], 0.0), [0; 0]);
    }

    #[test]
    fn shallow_minima_go_by_persistence() {
        let series = [5.0, 3.0, 1.0, 1.0 + 1e-7, 1.0 - 1e-8, 3.0, 5.0, 2.0, 5.0];
        assert_eq!(minima(&series, 5e-6), [4, 7]);
        assert_eq!(minima(&series, 0.0), [2, 4, 7]);
    }

    #[test]
    fn of_equal_minima_the_earlier_stays() {
        assert_eq!(minima(&[5.0, 1.0, 2.0, 1.0, 5.0], 1.5), [1]);
        assert_eq!(minima(&[5.0, 1.0, 2.0, 1.0, 5.0], 1.0), [1, 3]);
    }

    #[test]
    fn a_minimum_near_an_end_needs_its_depth_there_too() {
        assert_eq!(minima(&[1.5, 1.0, 5.0, 1.0, 1.5], 1.0), [0; 0]);
        assert_eq!(minima(&[2.0, 1.0, 5.0, 1.0, 2.0], 1.0), [1, 3]);
    }

    #[test]
    fn equals_the_rule_as_written_on_random_series() {
        let mut random = Random::new(6);
        for round in 0..4000 {
            let len = random.below(40);
            let steps = 2 + random.below(12);
            let series: Vec<f64> = (0..len)
                .map(|_| {
                    if round % 2 == 0 {
                        random.below(steps) as f64
                    } else {
                        random.unit()
                    }
                })
                .collect();
            let floor = if round % 2 == 0 {
                random.below(6) as f64
            } else {
                0.6 * random.unit()
            };
            assert_eq!(
                minima(&series, floor),
                minima_by_dropping(&series, floor),
                "{series:?} {floor}"
            );
        }
    }
}
