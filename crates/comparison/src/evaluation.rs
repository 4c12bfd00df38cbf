//! How well a distance tells labels apart: distances or clusters and labels in, scores out. Items
//! without a label are left out.

mod one_nearest_run;

pub use one_nearest_run::OneNearestRun;

/// Leave-one-out classification by the nearest other item.
#[derive(Clone, Debug, PartialEq)]
pub struct OneNearest {
    /// The nearest other labelled item of each item; none for one without a label, or where there is
    /// no other.
    pub nearest: Vec<Option<usize>>,
    /// Items with a label.
    pub labelled: usize,
    /// Those whose nearest has the same label.
    pub correct: usize,
    /// `correct / labelled`, 0 without any.
    pub accuracy: f64,
    /// The most that the accuracy can be: the only item of its label can never be right.
    pub best_reachable: f64,
    /// How often an item of one label has a nearest of another, or its own, by label.
    pub confusion: Vec<Confusion>,
    /// Items whose nearest is of another label, with that nearest.
    pub errors: Vec<(usize, usize)>,
    /// Labels with one item.
    pub single: Vec<usize>,
}

/// One field of the confusion matrix that is not 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Confusion {
    /// The label of the items.
    pub own: usize,
    /// The label of their nearest.
    pub nearest: usize,
    /// How many they are.
    pub count: usize,
}

/// How well clusters agree with labels (Miura et al. 2013, eq. 4), each from 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Scores {
    /// The part of its label that an item finds in its cluster, in the mean.
    pub recall: f64,
    /// The part of its cluster that has its label, in the mean.
    pub precision: f64,
    /// 2 R P / (R + P).
    pub f: f64,
}

impl OneNearest {
    /// What follows from the nearest other labelled item of each labelled one.
    fn of(labels: &[Option<usize>], nearest: Vec<Option<usize>>) -> Self {
        let label = |item: usize| labels[item].unwrap_or_default();
        let pairs = nearest.iter().enumerate();
        let pairs: Vec<(usize, usize)> = pairs
            .filter_map(|(item, near)| Some((item, (*near)?)))
            .collect();
        let (right, errors): (Vec<_>, Vec<_>) = pairs
            .iter()
            .partition(|(item, near)| label(*item) == label(*near));
        let labelled = labels.iter().flatten().count();
        let part = |count: usize| count as f64 / labelled.max(1) as f64;
        let single = single(labels);
        let labels_of = |(item, near): &(usize, usize)| (label(*item), label(*near));
        Self {
            labelled,
            correct: right.len(),
            accuracy: part(right.len()),
            best_reachable: part(labelled - single.len()),
            confusion: confusion(pairs.iter().map(labels_of)),
            errors,
            single,
            nearest,
        }
    }
}

/// Classifies every labelled item by its nearest other one; ties by order. `distance` is asked once
/// for every pair of labelled items, the smaller first. Where the nearest of all items are known:
/// [`OneNearestRun`].
pub fn leave_one_out(
    labels: &[Option<usize>],
    distance: impl FnMut(usize, usize) -> f64,
) -> OneNearest {
    OneNearest::of(labels, nearest(labels, distance))
}

/// Scores clusters against labels: with M_qc items of label c in cluster q, of M in all,
/// `R = Σ M_qc² / M_c / M` and `P = Σ M_qc² / M_q / M`; zeros without labels.
pub fn clustering(clusters: &[usize], labels: &[Option<usize>]) -> Scores {
    let items = clusters.iter().zip(labels);
    let items: Vec<(usize, usize)> = items.filter_map(|(q, c)| Some((*q, (*c)?))).collect();
    let of_cluster = counts(items.iter().map(|item| item.0));
    let of_label = counts(items.iter().map(|item| item.1));
    let (mut recall, mut precision) = (0.0, 0.0);
    for field in confusion(items.iter().copied()) {
        let (q, c) = (field.own, field.nearest);
        let square = (field.count * field.count) as f64;
        recall += square / of_label[c] as f64;
        precision += square / of_cluster[q] as f64;
    }
    let all = items.len().max(1) as f64;
    let (recall, precision) = (recall / all, precision / all);
    let sum = recall + precision;
    Scores {
        recall,
        precision,
        f: if sum > 0.0 {
            2.0 * recall * precision / sum
        } else {
            0.0
        },
    }
}

fn nearest(
    labels: &[Option<usize>],
    mut distance: impl FnMut(usize, usize) -> f64,
) -> Vec<Option<usize>> {
    let labelled: Vec<usize> = (0..labels.len())
        .filter(|item| labels[*item].is_some())
        .collect();
    let mut nearest = vec![None; labels.len()];
    let mut least = vec![f64::INFINITY; labels.len()];
    // Each item meets the others in their order, so that the first of equals stays.
    for (place, one) in labelled.iter().enumerate() {
        for other in &labelled[place + 1..] {
            let value = distance(*one, *other);
            for (item, near) in [(*one, *other), (*other, *one)] {
                if value < least[item] {
                    least[item] = value;
                    nearest[item] = Some(near);
                }
            }
        }
    }
    nearest
}

/// How often each number occurs.
fn counts(numbers: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut counts = Vec::new();
    for number in numbers {
        if counts.len() <= number {
            counts.resize(number + 1, 0);
        }
        counts[number] += 1;
    }
    counts
}

fn single(labels: &[Option<usize>]) -> Vec<usize> {
    let counts = counts(labels.iter().flatten().copied());
    (0..counts.len())
        .filter(|label| counts[*label] == 1)
        .collect()
}

/// How often each pair occurs, in order.
fn confusion(pairs: impl Iterator<Item = (usize, usize)>) -> Vec<Confusion> {
    let mut pairs: Vec<(usize, usize)> = pairs.collect();
    pairs.sort_unstable();
    let runs = pairs.chunk_by(|one, other| one == other);
    let field = |run: &[(usize, usize)]| Confusion {
        own: run[0].0,
        nearest: run[0].1,
        count: run.len(),
    };
    runs.map(field).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn on_a_line(places: &[f64]) -> impl Fn(usize, usize) -> f64 {
        move |one, other| (places[one] - places[other]).abs()
    }

    #[test]
    fn one_nearest_by_hand() {
        // Item 2 lies between its own and the others; label 2 has one item; item 4 has no label.
        let places = [0.0, 1.0, 3.0, 4.0, 4.5, 6.0, 10.0];
        let labels = [Some(0), Some(0), Some(0), Some(1), None, Some(1), Some(2)];
        let found = leave_one_out(&labels, on_a_line(&places));
        let nearest = [Some(1), Some(0), Some(3), Some(2), None, Some(3), Some(5)];
        assert_eq!(found.nearest, nearest);
        assert_eq!((found.labelled, found.correct), (6, 3));
        assert_eq!(found.accuracy, 0.5);
        assert_eq!(found.best_reachable, 5.0 / 6.0);
        assert_eq!(found.errors, [(2, 3), (3, 2), (6, 5)]);
        assert_eq!(found.single, [2]);
        let fields = [(0, 0, 2), (0, 1, 1), (1, 0, 1), (1, 1, 1), (2, 1, 1)];
        let fields = fields.map(|(own, nearest, count)| Confusion {
            own,
            nearest,
            count,
        });
        assert_eq!(found.confusion, fields);
    }

    #[test]
    fn of_equally_near_ones_the_first_counts() {
        let labels = [Some(0); 4];
        let found = leave_one_out(&labels, |_, _| 1.0);
        assert_eq!(found.nearest, [Some(1), Some(0), Some(0), Some(0)]);
    }

    #[test]
    fn without_labels_or_others_there_is_nothing_to_score() {
        let none = leave_one_out(&[None, None], |_, _| 1.0);
        assert_eq!(
            (none.labelled, none.accuracy, none.best_reachable),
            (0, 0.0, 0.0)
        );
        let one = leave_one_out(&[Some(3)], |_, _| 1.0);
        assert_eq!((one.labelled, one.correct, one.nearest), (1, 0, vec![None]));
        assert_eq!((one.single, one.best_reachable), (vec![3], 0.0));
        assert_eq!(clustering(&[0, 1], &[None, None]), Scores::default());
    }

    #[test]
    fn scores_of_clusters_by_hand() {
        // Cluster 0 holds 3 of label 0 and 1 of label 1, cluster 1 the other of label 0 and 1 of
        // label 1; one item has no label.
        let clusters = [0, 0, 0, 0, 1, 1, 1];
        let labels = [Some(0), Some(0), Some(0), Some(1), Some(0), Some(1), None];
        let found = clustering(&clusters, &labels);
        let recall = ((9.0 + 1.0) / 4.0 + (1.0 + 1.0) / 2.0) / 6.0;
        let precision = ((9.0 + 1.0) / 4.0 + (1.0 + 1.0) / 2.0) / 6.0;
        assert!((found.recall - recall).abs() < 1e-15);
        assert!((found.precision - precision).abs() < 1e-15);
        assert!((found.f - recall).abs() < 1e-15);
    }

    #[test]
    fn one_cluster_has_all_recall_and_single_ones_all_precision() {
        let labels = [Some(0), Some(0), Some(1)];
        let one = clustering(&[0, 0, 0], &labels);
        assert!((one.recall - 1.0).abs() < 1e-15);
        assert!((one.precision - 5.0 / 9.0).abs() < 1e-15);
        assert!((one.f - 5.0 / 7.0).abs() < 1e-15);
        let single = clustering(&[0, 1, 2], &labels);
        assert_eq!(single.precision, 1.0);
        assert!((single.recall - 2.0 / 3.0).abs() < 1e-15);
    }
}
