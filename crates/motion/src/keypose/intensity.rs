//! Intensity: what each candidate was at every time scale in, one number a candidate out.
//!
//! `U_c = Σ_i u_i`, `u_i = | L_i(m) − A_i(m) |` at the sample m of the level-i minimum that belongs
//! to candidate c. A candidate without any is of zero intensity.
//!
//! Source: Miura et al., "Adaptive Keypose Extraction from Motion Capture Data", 2014, §3.2, eq. 4.

use core::ops::Range;

/// Through the time scales, the minimum that belongs to each candidate: flat, candidate by
/// candidate.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Traces {
    /// Candidate c has the entries `offsets[c]..offsets[c + 1]`; its k-th entry is of scale k.
    pub offsets: Vec<usize>,
    /// The sample of the minimum, an index into the speed.
    pub frames: Vec<usize>,
    /// Where the minimum lies between the samples, within half a sample of `frames`.
    pub places: Vec<f64>,
    /// u of the minimum, in body heights per second.
    pub contributions: Vec<f64>,
}

impl Traces {
    /// The entries of one candidate, from the finest scale to the last that it reaches.
    pub fn entries(&self, candidate: usize) -> Range<usize> {
        self.offsets[candidate]..self.offsets[candidate + 1]
    }

    /// Samples and u of one candidate, scale by scale.
    pub fn of(&self, candidate: usize) -> (&[usize], &[f64]) {
        let entries = self.entries(candidate);
        (&self.frames[entries.clone()], &self.contributions[entries])
    }

    /// The scale (an index from the finest) of a candidate's largest u, of equals the finest; none
    /// for a candidate that reaches no scale.
    pub fn strongest_scale(&self, candidate: usize) -> Option<usize> {
        let (_, contributions) = self.of(candidate);
        let larger = |best: usize, scale: usize| match contributions[scale] > contributions[best] {
            true => scale,
            false => best,
        };
        (0..contributions.len()).reduce(larger)
    }

    /// U of every candidate; 0 without a trace (the standard library's sum of nothing is −0).
    pub fn intensity(&self) -> Vec<f64> {
        let candidates = 0..self.offsets.len().saturating_sub(1);
        let sum = |contributions: &[f64]| contributions.iter().fold(0.0, |sum, u| sum + u);
        candidates
            .map(|candidate| sum(self.of(candidate).1))
            .collect()
    }
}

/// One candidate's minimum at one time scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TraceEntry {
    /// The candidate.
    pub candidate: usize,
    /// The sample of the minimum.
    pub frame: usize,
    /// Where it lies between the samples.
    pub place: f64,
    /// Its u.
    pub contribution: f64,
}

/// Sorts entries that come scale by scale into traces of `candidates` candidates.
pub fn traces(candidates: usize, entries: &[TraceEntry]) -> Traces {
    let mut offsets = vec![0; candidates + 1];
    for entry in entries {
        offsets[entry.candidate + 1] += 1;
    }
    for candidate in 0..candidates {
        offsets[candidate + 1] += offsets[candidate];
    }
    let mut next = offsets.clone();
    let mut frames = vec![0; entries.len()];
    let mut places = vec![0.0; entries.len()];
    let mut contributions = vec![0.0; entries.len()];
    for entry in entries {
        let slot = next[entry.candidate];
        frames[slot] = entry.frame;
        places[slot] = entry.place;
        contributions[slot] = entry.contribution;
        next[entry.candidate] += 1;
    }
    Traces {
        offsets,
        frames,
        places,
        contributions,
    }
}

/// Where a minimum lies between the samples: the vertex of the parabola through its value and the
/// two beside it, as a distance from its sample, −0.5 to 0.5. 0 on a plateau.
pub fn vertex_offset(before: f64, at: f64, after: f64) -> f64 {
    if before <= at || after <= at {
        return 0.0;
    }
    let offset = 0.5 * (before - after) / ((before - at) + (after - at));
    offset.clamp(-0.5, 0.5)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_are_sorted_by_candidate_and_summed() {
        let entry = |candidate, frame, contribution| TraceEntry {
            candidate,
            frame,
            place: frame as f64 + 0.25,
            contribution,
        };
        let entries = [entry(0, 5, 1.0), entry(2, 9, 2.0), entry(2, 10, 0.5)];
        let traces = traces(3, &entries);
        assert_eq!(traces.of(2), ([9, 10].as_slice(), [2.0, 0.5].as_slice()));
        assert_eq!(traces.of(1).0.len(), 0);
        assert_eq!(traces.places, [5.25, 9.25, 10.25]);
        assert_eq!(traces.intensity(), [1.0, 0.0, 2.5]);
        assert!(traces.intensity()[1].is_sign_positive());
    }

    #[test]
    fn the_strongest_scale_is_the_finest_of_equals() {
        let entry = |candidate, contribution| TraceEntry {
            candidate,
            frame: 0,
            place: 0.0,
            contribution,
        };
        let entries = [1.0, 3.0, 3.0, 2.0].map(|contribution| entry(1, contribution));
        let traces = traces(2, &entries);
        assert_eq!(traces.strongest_scale(0), None);
        assert_eq!(traces.strongest_scale(1), Some(1));
    }

    #[test]
    fn a_vertex_is_found_between_the_samples() {
        // (x − 0.3)² at −1, 0, 1.
        let square = |x: f64| (x - 0.3) * (x - 0.3);
        let offset = vertex_offset(square(-1.0), square(0.0), square(1.0));
        assert!((offset - 0.3).abs() < 1e-15);
        assert_eq!(vertex_offset(2.0, 1.0, 1.0), 0.0);
        assert_eq!(vertex_offset(1.0, 1.0, 2.0), 0.0);
        assert_eq!(vertex_offset(1.0, 1.0 - f64::EPSILON, 1e300), -0.5);
        assert_eq!(vertex_offset(3.0, 1.0, 3.0), 0.0);
    }
}
