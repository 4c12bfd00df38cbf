//! How sure a selection is: intensities and which were kept in, the ratio at the cut out.

/// Below this ratio a cut is called uncertain.
pub const SURE_FROM: f64 = 1.5;

/// Where the cut between kept and dropped candidates lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sureness {
    /// The lowest kept intensity over the highest dropped one. Infinite, that is certain, where
    /// nothing or only zeros were dropped; zero where something was dropped and nothing kept.
    pub ratio: f64,
    /// The lowest kept intensity.
    pub lowest_kept: Option<f64>,
    /// The highest dropped intensity.
    pub highest_dropped: Option<f64>,
}

impl Sureness {
    /// Where the cut is drawn: the middle of the lowest kept and the highest dropped intensity, of
    /// 0 where nothing was dropped; none without a kept one.
    pub fn cut(&self) -> Option<f64> {
        Some((self.lowest_kept? + self.highest_dropped.unwrap_or(0.0)) / 2.0)
    }

    /// Whether the cut is clear.
    pub fn is_sure(&self) -> bool {
        self.ratio >= SURE_FROM
    }
}

/// How sure the selection `kept` (indices in ascending order) of `intensity` is.
pub fn sureness(intensity: &[f64], kept: &[usize]) -> Sureness {
    let mut is_kept = vec![false; intensity.len()];
    for &index in kept {
        is_kept[index] = true;
    }
    let (mut lowest_kept, mut highest_dropped) = (None, None);
    for (&value, &is_kept) in intensity.iter().zip(&is_kept) {
        if is_kept {
            lowest_kept = Some(lowest_kept.map_or(value, |lowest: f64| lowest.min(value)));
        } else {
            highest_dropped =
                Some(highest_dropped.map_or(value, |highest: f64| highest.max(value)));
        }
    }
    let ratio = match highest_dropped {
        Some(dropped) if dropped > 0.0 => lowest_kept.unwrap_or(0.0) / dropped,
        _ => f64::INFINITY,
    };
    Sureness {
        ratio,
        lowest_kept,
        highest_dropped,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ratio_is_taken_at_the_cut() {
        let found = sureness(&[4.0, 1.0, 0.0, 2.0], &[0, 3]);
        assert_eq!(found.ratio, 2.0);
        assert_eq!(
            (found.lowest_kept, found.highest_dropped),
            (Some(2.0), Some(1.0))
        );
        assert!(found.is_sure());
        assert!(!sureness(&[3.0, 2.1], &[0]).is_sure());
    }

    #[test]
    fn dropping_nothing_or_zeros_is_certain() {
        assert_eq!(sureness(&[4.0, 0.0], &[0]).ratio, f64::INFINITY);
        assert_eq!(sureness(&[4.0], &[0]).ratio, f64::INFINITY);
        assert_eq!(sureness(&[], &[]).ratio, f64::INFINITY);
        assert_eq!(sureness(&[4.0], &[]).ratio, 0.0);
    }
}
