//! Heights of merges in; the number of clusters by Mojena's first stopping rule out.

/// The deviations above the mean that stop the merging of a set (Milligan and Cooper 1985).
pub const DEVIATIONS: f64 = 1.25;

/// Cuts before the first merge higher than the mean of all by more than `deviations` of them
/// (unbiased; Mojena 1977, rule one). `heights` lowest first, one fewer than the items; one cluster
/// where none is that high.
#[must_use]
pub fn mojena(heights: &[f64], deviations: f64) -> usize {
    let count = heights.len() as f64;
    if heights.len() < 2 {
        return 1;
    }
    let mean = heights.iter().sum::<f64>() / count;
    let squares: f64 = heights
        .iter()
        .map(|height| (height - mean) * (height - mean))
        .sum();
    let limit = mean + deviations * (squares / (count - 1.0)).sqrt();
    let made = heights.iter().position(|&height| height > limit);
    made.map_or(1, |made| heights.len() + 1 - made)
}
