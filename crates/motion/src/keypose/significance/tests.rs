//! The case list of the method, and each step of the rule.

use super::*;

fn kept_values(intensity: &[f64], selection: SelectionRule) -> Vec<f64> {
    let options = Options {
        selection,
        ..Options::default()
    };
    let selection = select(intensity, &options);
    selection
        .kept
        .iter()
        .map(|&index| intensity[index])
        .collect()
}

fn automatic(intensity: &[f64]) -> Vec<f64> {
    kept_values(intensity, SelectionRule::Automatic)
}

#[test]
fn cases_that_tell_implementations_apart() {
    let mut many_zeros = vec![0.0; 16];
    many_zeros.extend([
        1.6, 0.8, 0.3, 0.2, 1.7, 1.6, 1.4, 0.5, 1.6, 1.1, 1.5, 0.1, 0.5, 1.7, 0.3, 0.1, 1.8, 1.0,
        1.2, 3.9, 9.6, 5.8, 18.0,
    ]);
    assert_eq!(automatic(&many_zeros), [18.0]);
    let no_zero = [
        0.2, 1.9, 0.6, 0.1, 20.0, 0.2, 19.0, 0.1, 1.9, 1.5, 0.2, 0.6, 19.2,
    ];
    assert_eq!(automatic(&no_zero), [20.0, 19.0, 19.2]);
    let silent = [0.1, 4.8, 0.7, 0.0, 2.3, 0.0, 1.1, 1.9, 0.2, 0.0, 0.0, 0.9];
    assert_eq!(automatic(&silent), [4.8, 2.3, 1.9]);
}

#[test]
fn nothing_positive_keeps_nothing() {
    for rule in [
        SelectionRule::Automatic,
        SelectionRule::Literal,
        SelectionRule::EvenSplit,
    ] {
        assert_eq!(kept_values(&[], rule), [0.0; 0]);
        assert_eq!(kept_values(&[0.0; 3], rule), [0.0; 0]);
        assert_eq!(kept_values(&[0.0; 20], rule), [0.0; 0]);
    }
    let selection = select(&[0.0; 3], &Options::default());
    assert_eq!(
        (selection.ground, selection.clusters),
        (Ground::NoIntensity, 1)
    );
}

#[test]
fn a_largest_or_equal_first_gap_keeps_all() {
    assert_eq!(automatic(&[3.0, 0.0, 4.0, 5.0]), [3.0, 4.0, 5.0]);
    assert_eq!(automatic(&[1.0, 2.0, 3.0]), [1.0, 2.0, 3.0]);
    assert_eq!(automatic(&[7.0]), [7.0]);
    let many: Vec<f64> = (0..20).map(|n| 10.0 + f64::from(n % 5)).collect();
    assert_eq!(automatic(&many), many);
}

#[test]
fn few_candidates_are_cut_at_the_largest_gap() {
    assert_eq!(automatic(&[1.0, 3.0, 3.5, 1.2]), [3.0, 3.5]);
    // Equal gaps: the lowest.
    assert_eq!(automatic(&[1.0, 3.0, 5.0]), [3.0, 5.0]);
    let selection = select(&[1.0, 3.0, 5.0], &Options::default());
    assert_eq!(
        (selection.ground, selection.clusters),
        (Ground::LargestGap, 2)
    );
    assert_eq!(selection.cluster_of, [0, 1, 1]);
    assert_eq!(selection.analysis_of_variance, None);
    // Nine candidates, zeros counted, are few; ten are not.
    let mut nine = vec![0.0, 0.0, 1.0, 1.0, 1.1, 1.2, 4.0, 4.1, 12.0];
    assert_eq!(
        select(&nine, &Options::default()).ground,
        Ground::LargestGap
    );
    nine.push(0.0);
    assert_ne!(
        select(&nine, &Options::default()).ground,
        Ground::LargestGap
    );
}

#[test]
fn the_literal_rule_keeps_nothing_or_everything_where_it_is_silent() {
    assert_eq!(
        kept_values(&[0.0, 4.0, 4.1], SelectionRule::Literal),
        [0.0; 0]
    );
    assert_eq!(
        kept_values(&[0.1, 4.0, 4.1], SelectionRule::Literal),
        [0.1, 4.0, 4.1]
    );
    let selection = select(
        &[0.1, 4.0, 4.1],
        &Options {
            selection: SelectionRule::Literal,
            ..Options::default()
        },
    );
    assert_eq!(
        (selection.ground, selection.clusters),
        (Ground::MojenaSilent, 1)
    );
    assert_eq!(selection.analysis_of_variance, None);
}

#[test]
fn the_literal_rule_deletes_the_cluster_of_zeros_where_it_fires() {
    let mut intensity = vec![0.0, 0.1, 0.0, 0.2, 0.1, 0.3, 0.2, 0.1, 0.2, 0.15, 0.05, 0.1];
    intensity.extend([20.0, 20.1]);
    assert_eq!(
        kept_values(&intensity, SelectionRule::Literal),
        [20.0, 20.1]
    );
    let options = Options {
        selection: SelectionRule::Literal,
        ..Options::default()
    };
    let selection = select(&intensity, &options);
    assert_eq!((selection.ground, selection.clusters), (Ground::Mojena, 2));
    let test = selection.analysis_of_variance.unwrap();
    assert_eq!((test.df_between, test.df_within), (1, 12));
    assert!(test.p < 0.01);
}

#[test]
fn the_even_split_is_the_best_of_all_splits() {
    let intensity = [0.1, 4.8, 0.7, 0.0, 2.3, 0.0, 1.1, 1.9, 0.2, 0.0, 0.0, 0.9];
    let mut values = intensity.to_vec();
    values.push(0.0);
    values.sort_by(f64::total_cmp);
    let within = |part: &[f64]| {
        let mean = part.iter().sum::<f64>() / part.len() as f64;
        part.iter()
            .map(|value| (value - mean) * (value - mean))
            .sum::<f64>()
    };
    let cost = |at: usize| within(&values[..at]) + within(&values[at..]);
    let best = (1..values.len())
        .min_by(|&a, &b| cost(a).total_cmp(&cost(b)))
        .unwrap();
    assert_eq!(even_split(&values), best);
    let kept = kept_values(&intensity, SelectionRule::EvenSplit);
    assert_eq!(kept.len(), values.len() - best);
    assert_eq!(
        kept_values(&[2.0, 2.0], SelectionRule::EvenSplit),
        [2.0, 2.0]
    );
}

#[test]
fn the_reference_counts_in_no_cluster() {
    // With a low k the rule fires before the reference has merged with anything.
    let mut intensity: Vec<f64> = (0..12).map(|n| 50.0 + 0.01 * f64::from(n)).collect();
    intensity.push(120.0);
    let options = Options {
        mojena_k: 1.0,
        ..Options::default()
    };
    let selection = select(&intensity, &options);
    assert_eq!(selection.ground, Ground::Mojena);
    assert_eq!(selection.kept.len(), 13);
    assert_eq!(selection.clusters, 2);
    assert_eq!((selection.cluster_of[0], selection.cluster_of[12]), (0, 1));
    assert_eq!(selection.analysis_of_variance.unwrap().df_within, 11);
}
