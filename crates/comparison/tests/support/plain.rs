//! The linkages by their definitions, without cleverness: the nearest two of all clusters merge.

use comparison::condensed::Condensed;
use comparison::dendrogram::Merge;
use comparison::feature::{FEATURE_LENGTH, Vector};

/// Ward: the square of a height is twice what the merge adds to the squared distances from the
/// centroids.
pub fn ward(vectors: &[Vector]) -> Vec<Merge> {
    let squares = |items: &[usize]| {
        let components = 0..FEATURE_LENGTH;
        let of_component = |k: usize| {
            let values = || items.iter().map(|&item| vectors[item][k]);
            let mean = values().sum::<f64>() / items.len() as f64;
            values()
                .map(|value| (value - mean) * (value - mean))
                .sum::<f64>()
        };
        components.map(of_component).sum::<f64>()
    };
    merged(vectors.len(), |one, other| {
        let both = [one, other].concat();
        let added = squares(&both) - squares(one) - squares(other);
        (2.0 * added.max(0.0)).sqrt()
    })
}

/// Group average: the mean over the pairs of items.
pub fn group_average(condensed: &Condensed) -> Vec<Merge> {
    merged(condensed.items, |one, other| {
        let pairs = one.iter().flat_map(|&a| other.iter().map(move |&b| (a, b)));
        let sum: f64 = pairs.map(|(a, b)| condensed.at(a, b)).sum();
        sum / (one.len() * other.len()) as f64
    })
}

fn merged(items: usize, distance: impl Fn(&[usize], &[usize]) -> f64) -> Vec<Merge> {
    let mut clusters: Vec<(usize, Vec<usize>)> =
        (0..items).map(|item| (item, vec![item])).collect();
    let mut merges = Vec::new();
    while clusters.len() > 1 {
        let mut best = (0, 1, f64::INFINITY);
        for one in 0..clusters.len() {
            for other in one + 1..clusters.len() {
                let height = distance(&clusters[one].1, &clusters[other].1);
                if height < best.2 {
                    best = (one, other, height);
                }
            }
        }
        let (right, mut inner) = clusters.remove(best.1);
        let (left, outer) = clusters.remove(best.0);
        inner.extend(outer);
        merges.push(Merge {
            left: left.min(right),
            right: left.max(right),
            height: best.2,
            size: inner.len(),
        });
        clusters.push((items + merges.len() - 1, inner));
    }
    merges
}
