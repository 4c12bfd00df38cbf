//! Clusters in; the same in an order out in which every `LANES` of them lie near each other.

use super::block::{LANES, Member};
use crate::feature::FEATURE_LENGTH;

/// Halves the clusters across their widest component, at whole blocks, until blocks are left.
pub(super) fn sort(members: &mut [Member]) {
    let mut waiting = vec![members];
    while let Some(part) = waiting.pop() {
        let blocks = part.len().div_ceil(LANES);
        if blocks <= 1 {
            continue;
        }
        let component = widest(part);
        let middle = blocks / 2 * LANES;
        part.select_nth_unstable_by(middle, |a, b| {
            a.centroid[component].total_cmp(&b.centroid[component])
        });
        let (low, high) = part.split_at_mut(middle);
        waiting.push(high);
        waiting.push(low);
    }
}

fn widest(members: &[Member]) -> usize {
    let width = |k: usize| {
        let values = members.iter().map(|member| member.centroid[k]);
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(value), high.max(value))
        });
        high - low
    };
    (0..FEATURE_LENGTH)
        .max_by(|&a, &b| width(a).total_cmp(&width(b)))
        .unwrap_or(0)
}
