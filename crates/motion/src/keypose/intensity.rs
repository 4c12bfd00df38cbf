//! Intensity: what each candidate was at every time scale in, one number a candidate out.
//!
//! `U_c = Σ_i u_i`, `u_i = | L_i(m) − A_i(m) |` at the sample m of the level-i minimum that belongs
//! to candidate c. A candidate without any is of zero intensity.
//!
//! Source: Miura et al., "Adaptive Keypose Extraction from Motion Capture Data", 2014, §3.2, eq. 4.

/// Through the time scales, the minimum that belongs to each candidate: flat, candidate by
/// candidate.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Traces {
    /// Candidate c has the entries `offsets[c]..offsets[c + 1]`; its k-th entry is of scale k.
    pub offsets: Vec<usize>,
    /// The sample of the minimum, an index into the speed.
    pub frames: Vec<usize>,
    /// u of the minimum, in body heights per second.
    pub contributions: Vec<f64>,
}

impl Traces {
    /// Samples and u of one candidate, from the finest scale to the last that it reaches.
    pub fn of(&self, candidate: usize) -> (&[usize], &[f64]) {
        let entries = self.offsets[candidate]..self.offsets[candidate + 1];
        (&self.frames[entries.clone()], &self.contributions[entries])
    }

    /// U of every candidate.
    pub fn intensity(&self) -> Vec<f64> {
        let candidates = 0..self.offsets.len().saturating_sub(1);
        candidates
            .map(|candidate| self.of(candidate).1.iter().sum())
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
    let mut contributions = vec![0.0; entries.len()];
    for entry in entries {
        let place = next[entry.candidate];
        frames[place] = entry.frame;
        contributions[place] = entry.contribution;
        next[entry.candidate] += 1;
    }
    Traces {
        offsets,
        frames,
        contributions,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_are_sorted_by_candidate_and_summed() {
        let entry = |candidate, frame, contribution| TraceEntry {
            candidate,
            frame,
            contribution,
        };
        let entries = [entry(0, 5, 1.0), entry(2, 9, 2.0), entry(2, 10, 0.5)];
        let traces = traces(3, &entries);
        assert_eq!(traces.of(2), ([9, 10].as_slice(), [2.0, 0.5].as_slice()));
        assert_eq!(traces.of(1).0.len(), 0);
        assert_eq!(traces.intensity(), [1.0, 0.0, 2.5]);
    }
}
