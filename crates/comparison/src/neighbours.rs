//! Neighbours: one item's distances to all items in, the items by nearness out.

/// The items but `itself`, the nearest first, of equals the earlier.
pub fn nearest_first(distances: &[f64], itself: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (0..distances.len())
        .filter(|item| *item != itself)
        .collect();
    order.sort_by(|one, other| distances[*one].total_cmp(&distances[*other]));
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_comes_first_and_of_equals_the_earlier() {
        let order = nearest_first(&[2.0, 0.0, 1.0, 3.0, 1.0, 0.0], 1);
        assert_eq!(order, [5, 2, 4, 0, 3]);
        assert!(nearest_first(&[0.0], 0).is_empty());
    }
}
