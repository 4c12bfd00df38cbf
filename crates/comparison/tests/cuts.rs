//! Cuts of trees, their names as Newick, and the two stopping rules on small cases worked out by hand.

use comparison::cut::{bic, mojena};
use comparison::dendrogram::{Dendrogram, Merge};
use comparison::feature::{FEATURE_LENGTH, Vector};
use comparison::linkage;

/// Items 0 and 3 merge at 1, 1 and 2 at 2, all at 5.
fn tree() -> Dendrogram {
    let merge = |left, right, height, size| Merge {
        left,
        right,
        height,
        size,
    };
    Dendrogram {
        items: 4,
        merges: vec![
            merge(0, 3, 1.0, 2),
            merge(1, 2, 2.0, 2),
            merge(4, 5, 5.0, 4),
        ],
    }
}

#[test]
fn cuts_number_clusters_by_their_first_items() {
    let tree = tree();
    assert_eq!(tree.cut(1), [0, 0, 0, 0]);
    assert_eq!(tree.cut(2), [0, 1, 1, 0]);
    assert_eq!(tree.cut(3), [0, 1, 2, 0]);
    assert_eq!(tree.cut(4), [0, 1, 2, 3]);
    assert_eq!(tree.cut(0), tree.cut(1));
    assert_eq!(tree.cut(9), tree.cut(4));
}

#[test]
fn cuts_can_be_numbered_by_their_leaves() {
    let tree = tree();
    let leaves = [2, 1, 3, 0];
    assert_eq!(tree.cut_by_leaves(2, &leaves), [1, 0, 0, 1]);
    assert_eq!(tree.cut_by_leaves(3, &leaves), [2, 1, 0, 2]);
}

#[test]
fn heights_cut_between_merges() {
    let tree = tree();
    let heights: Vec<f64> = (1..=4).map(|clusters| tree.cut_height(clusters)).collect();
    assert_eq!(heights, [5.0, 3.5, 1.5, 0.5]);
    for clusters in 1..=4 {
        assert_eq!(tree.clusters_at(tree.cut_height(clusters)), clusters);
    }
    assert_eq!(tree.clusters_at(1.0), 3);
}

#[test]
fn newick_adds_up_to_heights_and_quotes_names() {
    let names = ["walk-1.2", "o'clock", "a b", "under_score"];
    let expected = "(('walk-1.2':1,'under_score':1):4,('o''clock':2,'a b':2):3):0;";
    let expected = expected.replace("'walk-1.2'", "walk-1.2");
    assert_eq!(tree().newick(&[0, 3, 1, 2], &names), expected);
}

#[test]
fn newick_of_little() {
    let nothing = linkage::ward(&[]);
    assert_eq!(nothing.newick::<&str>(&[], &[]), ";");
    let one = linkage::ward(&[[0.0; FEATURE_LENGTH]]);
    assert_eq!(one.newick(&[0], &["(a)"]), "'(a)':0;");
    let leaves = [0, 3, 1, 2];
    assert_eq!(
        tree().newick(&leaves, &[""]),
        "(('':1,3:1):4,(1:2,2:2):3):0;"
    );
}

#[test]
fn newick_stands_in_the_order_of_the_leaves_on_one_line() {
    let names = ["a", "b\nb", "c", "d"];
    for (leaves, expected) in [
        ([0, 3, 1, 2], "((a:1,d:1):4,('b b':2,c:2):3):0;"),
        ([2, 1, 0, 3], "((c:2,'b b':2):3,(a:1,d:1):4):0;"),
        ([3, 0, 2, 1], "((d:1,a:1):4,(c:2,'b b':2):3):0;"),
    ] {
        assert_eq!(tree().newick(&leaves, &names), expected);
    }
}

/// Heights 1, 1, 1, 9: mean 3, squares 4 + 4 + 4 + 36 = 48, deviation sqrt(48 / 3) = 4. The limit is
/// 8 for k = 1.25, so the last merge is not made; for k = 1.5 it is 9, and 9 is not above it.
#[test]
fn mojena_stops_before_a_height_far_above_the_mean() {
    let heights = [1.0, 1.0, 1.0, 9.0];
    assert_eq!(mojena::mojena(&heights, 1.25), 2);
    assert_eq!(mojena::mojena(&heights, 1.5), 1);
}

/// Heights 0, 0, 0, 0, 0, 0, 6, 6: mean 1.5, squares 6 · 2.25 + 2 · 20.25 = 54, deviation
/// sqrt(54 / 7) = 2.777; the limit for 1.25 is 4.97: two merges are not made.
#[test]
fn mojena_stops_before_the_first_of_several() {
    let heights = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 6.0, 6.0];
    assert_eq!(mojena::mojena(&heights, mojena::DEVIATIONS), 3);
}

#[test]
fn mojena_of_little_is_one_cluster() {
    assert_eq!(mojena::mojena(&[], 1.25), 1);
    assert_eq!(mojena::mojena(&[3.0], 1.25), 1);
    assert_eq!(mojena::mojena(&[2.0; 5], 1.25), 1);
}

/// Six items that differ in one component: −5, −4, −3 and 3, 4, 5. n = 6, so G is 1 or 2; d = 1, since
/// the other components do not vary.
///
/// G = 1: mean 0, squares 2 · (25 + 16 + 9) = 100, v = 100 / 6; ln L = −½ · (6 ln(2π v) + 6);
/// p = 0 + 1 + 1 = 2; BIC = −6 ln(2π · 100 / 6) − 6 − 2 ln 6 = −37.4915….
///
/// G = 2: means ∓4, squares 4, v = 4 / 6; ln L = −½ · (6 ln(2π v) + 6) + 6 ln ½; p = 1 + 2 + 1 = 4;
/// BIC = −6 ln(2π · 4 / 6) − 6 − 12 ln 2 − 4 ln 6 = −30.0793….
#[test]
fn bic_of_two_groups_on_a_line() {
    let vectors = on_a_line(&[-5.0, -4.0, -3.0, 3.0, 4.0, 5.0]);
    let values = bic::bic(&vectors, &linkage::ward(&vectors));
    let ln = libm::log;
    let tau = std::f64::consts::TAU;
    let one = -6.0 * ln(tau * 100.0 / 6.0) - 6.0 - 2.0 * ln(6.0);
    let two = -6.0 * ln(tau * 4.0 / 6.0) - 6.0 - 12.0 * ln(2.0) - 4.0 * ln(6.0);
    assert_eq!(values.len(), 2);
    assert!((values[0] - one).abs() < 1e-12, "{values:?} {one}");
    assert!((values[1] - two).abs() < 1e-12, "{values:?} {two}");
    assert_eq!(bic::best(&values), 2);
}

/// Two places, three items each: the variance within is held at 1e-6 of the variance of all, 1, and
/// the sum of squares is 0. BIC(2) = −6 ln(2π · 1e-6) − 0 − 12 ln 2 − 4 ln 6.
#[test]
fn bic_of_copies_holds_the_variance_above_nothing() {
    let vectors = on_a_line(&[-1.0, 1.0, -1.0, 1.0, -1.0, 1.0]);
    let values = bic::bic(&vectors, &linkage::ward(&vectors));
    let ln = libm::log;
    let expected = -6.0 * ln(std::f64::consts::TAU * 1e-6) - 12.0 * ln(2.0) - 4.0 * ln(6.0);
    assert!(
        (values[1] - expected).abs() < 1e-12,
        "{values:?} {expected}"
    );
}

#[test]
fn bic_of_little_is_one_cluster() {
    let none = bic::bic(&[], &linkage::ward(&[]));
    assert!(none.is_empty());
    assert_eq!(bic::best(&none), 1);
    let two = on_a_line(&[0.0, 1.0]);
    assert!(bic::bic(&two, &linkage::ward(&two)).is_empty());
    let equal = vec![[0.25; FEATURE_LENGTH]; 7];
    assert_eq!(bic::best(&bic::bic(&equal, &linkage::ward(&equal))), 1);
}

fn on_a_line(places: &[f64]) -> Vec<Vector> {
    let vector = |&place: &f64| {
        let mut vector = [0.0; FEATURE_LENGTH];
        vector[0] = place;
        vector
    };
    places.iter().map(vector).collect()
}
