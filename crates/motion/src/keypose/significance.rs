//! Which candidates are keyposes: their intensities in, the kept ones and the clusters out.
//!
//! The published rule clusters the intensities with Ward's method, cuts by Mojena's rule one (the
//! first merge height above mean + k · standard deviation of all heights) and deletes the cluster
//! that contains a candidate of zero intensity. It needs such a candidate and at least ten merges
//! to be able to fire; [`SelectionRule::Automatic`] is the same where the rule applies, and
//! reasonable elsewhere:
//!
//! 1. Candidates of zero intensity are never keyposes.
//! 2. If among the positive intensities, with a zero in front, the first gap is the largest, all
//!    of them are kept.
//! 3. Else, with fewer than ten candidates, those above the largest gap are kept.
//! 4. Else Ward and Mojena, on the intensities and one zero reference; the clusters that contain a
//!    zero are deleted. Where the rule does not fire, there are two clusters.
//!
//! Sources: Miura et al., 2014, §3.2; R. Mojena, "Hierarchical grouping methods and stopping
//! rules: an evaluation", The Computer Journal 20, 1977.

use super::analysis_of_variance::{AnalysisOfVariance, analysis_of_variance};
use super::options::{Options, SelectionRule};
use super::ward::{Merge, merges};

/// With fewer candidates Mojena's rule at k = 2.75 cannot fire: the largest z-score of n values
/// is (n − 1) / √n.
const WARD_FROM: usize = 10;

/// What the selection rests on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ground {
    /// No candidate has an intensity above zero: nothing is kept.
    NoIntensity,
    /// The gap above zero is the largest: every positive intensity is kept.
    GapAboveZero,
    /// Few candidates: those above the largest gap are kept.
    LargestGap,
    /// Ward's clusters, cut by Mojena's rule.
    Mojena,
    /// Mojena's rule fired nowhere: two clusters (automatic) or one (literal).
    MojenaSilent,
    /// The two-class split with the least squares within.
    EvenSplit,
}

/// The kept candidates and how they were found.
#[derive(Clone, Debug, PartialEq)]
pub struct Selection {
    /// Indices of the kept candidates, ascending.
    pub kept: Vec<usize>,
    /// What the selection rests on.
    pub ground: Ground,
    /// The cluster of each candidate, counted from 0 at the lowest intensities. Where no
    /// clustering was made: 0 for dropped and 1 for kept candidates.
    pub cluster_of: Vec<usize>,
    /// How many clusters hold a candidate.
    pub clusters: usize,
    /// The F-test over the clusters; none where it is not defined (one cluster) or no clustering
    /// was made.
    pub analysis_of_variance: Option<AnalysisOfVariance>,
}

/// Selects among candidates by their `intensity` (never negative).
pub fn select(intensity: &[f64], options: &Options) -> Selection {
    let sorted = Sorted::new(intensity);
    match options.selection {
        SelectionRule::Literal => sorted.literal(options.mojena_k),
        _ if sorted.zeros == intensity.len() => {
            sorted.by_threshold(intensity.len(), Ground::NoIntensity)
        }
        SelectionRule::Automatic => sorted.automatic(options.mojena_k),
        SelectionRule::EvenSplit => {
            let values = sorted.with_reference();
            sorted.by_clusters(&[even_split(&values)], true, Ground::EvenSplit)
        }
    }
}

/// Intensities in ascending order.
struct Sorted<'a> {
    intensity: &'a [f64],
    /// Candidate indices by rising intensity.
    order: Vec<usize>,
    /// How many intensities are not above zero.
    zeros: usize,
}

impl<'a> Sorted<'a> {
    fn new(intensity: &'a [f64]) -> Self {
        let mut order: Vec<usize> = (0..intensity.len()).collect();
        order.sort_by(|&a, &b| intensity[a].total_cmp(&intensity[b]).then(a.cmp(&b)));
        let zeros = intensity.iter().filter(|&&value| value <= 0.0).count();
        Self {
            intensity,
            order,
            zeros,
        }
    }

    fn value(&self, place: usize) -> f64 {
        self.intensity[self.order[place]]
    }

    fn values(&self) -> Vec<f64> {
        self.order
            .iter()
            .map(|&index| self.intensity[index])
            .collect()
    }

    /// The values with a zero in front.
    fn with_reference(&self) -> Vec<f64> {
        let mut values = self.values();
        values.insert(0, 0.0);
        values
    }

    fn automatic(&self, mojena_k: f64) -> Selection {
        let lowest = self.value(self.zeros);
        let (gap, place) = self.largest_gap();
        if lowest >= gap {
            self.by_threshold(self.zeros, Ground::GapAboveZero)
        } else if self.order.len() < WARD_FROM {
            self.by_threshold(place, Ground::LargestGap)
        } else {
            let merges = merges(&self.with_reference());
            match mojena_cut(&merges, mojena_k) {
                Some(cut) => self.by_clusters(&boundaries(&merges[cut..]), true, Ground::Mojena),
                None => {
                    let last = &merges[merges.len() - 1..];
                    self.by_clusters(&boundaries(last), true, Ground::MojenaSilent)
                }
            }
        }
    }

    fn literal(&self, mojena_k: f64) -> Selection {
        let merges = merges(&self.values());
        match mojena_cut(&merges, mojena_k) {
            Some(cut) => self.by_clusters(&boundaries(&merges[cut..]), false, Ground::Mojena),
            None => self.by_clusters(&[], false, Ground::MojenaSilent),
        }
    }

    /// The largest gap between neighbouring positive intensities, of equals the lowest, and the
    /// place above it; zero where there is but one.
    fn largest_gap(&self) -> (f64, usize) {
        let mut largest = (0.0, self.zeros);
        for place in self.zeros + 1..self.order.len() {
            let gap = self.value(place) - self.value(place - 1);
            if gap > largest.0 {
                largest = (gap, place);
            }
        }
        largest
    }

    /// Keeps everything from `place` on.
    fn by_threshold(&self, place: usize, ground: Ground) -> Selection {
        let mut cluster_of = vec![0; self.order.len()];
        for &index in &self.order[place..] {
            cluster_of[index] = 1;
        }
        let clusters = usize::from(place > 0) + usize::from(place < self.order.len());
        Selection {
            kept: ascending(&self.order[place..]),
            ground,
            cluster_of,
            clusters,
            analysis_of_variance: None,
        }
    }

    /// Clusters between ascending `boundaries`, counted with the reference in front if there is
    /// one; keeps the clusters without a zero.
    fn by_clusters(&self, boundaries: &[usize], reference: bool, ground: Ground) -> Selection {
        let shift = usize::from(reference);
        let cluster_at =
            |place: usize| boundaries.partition_point(|&boundary| boundary <= place + shift);
        let first = if self.order.is_empty() {
            0
        } else {
            cluster_at(0)
        };
        let mut cluster_of = vec![0; self.order.len()];
        for (place, &index) in self.order.iter().enumerate() {
            cluster_of[index] = cluster_at(place) - first;
        }
        let with_zero = boundaries
            .iter()
            .copied()
            .find(|&boundary| boundary >= self.zeros + shift);
        let start = match self.zeros + shift {
            0 => 0,
            _ => with_zero.map_or(self.order.len(), |boundary| boundary - shift),
        };
        Selection {
            kept: ascending(&self.order[start..]),
            ground,
            clusters: self.order.len().min(boundaries.len() + 1 - first),
            analysis_of_variance: analysis_of_variance(self.intensity, &cluster_of),
            cluster_of,
        }
    }
}

/// The first merge whose height lies more than `k` standard deviations (unbiased) above the mean
/// of all heights, if any.
fn mojena_cut(merges: &[Merge], k: f64) -> Option<usize> {
    if merges.len() < 2 {
        return None;
    }
    let count = merges.len() as f64;
    let mean = merges.iter().map(|merge| merge.height).sum::<f64>() / count;
    let squares = merges
        .iter()
        .map(|merge| (merge.height - mean) * (merge.height - mean));
    let deviation = (squares.sum::<f64>() / (count - 1.0)).sqrt();
    merges
        .iter()
        .position(|merge| merge.height > mean + k * deviation)
}

fn boundaries(merges: &[Merge]) -> Vec<usize> {
    let mut boundaries: Vec<usize> = merges.iter().map(|merge| merge.boundary).collect();
    boundaries.sort_unstable();
    boundaries
}

fn ascending(indices: &[usize]) -> Vec<usize> {
    let mut indices = indices.to_vec();
    indices.sort_unstable();
    indices
}

/// The boundary between two classes of ascending `values` with the least sum of squares within,
/// which is the greatest `n_a n_b / n · (mean_a − mean_b)²`; of equals the lowest.
fn even_split(values: &[f64]) -> usize {
    let total: f64 = values.iter().sum();
    let (mut below, mut best) = (0.0, (0.0, values.len()));
    for index in 1..values.len() {
        below += values[index - 1];
        let (n_a, n_b) = (index as f64, (values.len() - index) as f64);
        let gap = (total - below) / n_b - below / n_a;
        let between = n_a * n_b * (gap * gap);
        if between > best.0 {
            best = (between, index);
        }
    }
    best.1
}

#[cfg(test)]
mod tests;
