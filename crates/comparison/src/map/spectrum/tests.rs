//! Spectra known by hand, and the leading part of a large one.

use super::*;

fn of(rows: &[&[f64]]) -> Spectrum {
    spectrum(rows.len(), rows.len(), |from, to| {
        for (value, row) in to.iter_mut().zip(rows) {
            *value = dot(row, from);
        }
    })
}

#[test]
fn a_small_matrix_by_hand() {
    // Eigenvalues 3 along (1, 1), 1 along (1, −1), −2 along the third axis.
    let found = of(&[&[2.0, 1.0, 0.0], &[1.0, 2.0, 0.0], &[0.0, 0.0, -2.0]]);
    for (value, expected) in found.values.iter().zip([3.0, 1.0, -2.0]) {
        assert!((value - expected).abs() < 1e-13, "{:?}", found.values);
    }
    let half = 0.5_f64.sqrt();
    let [first, second] = &found.axes;
    assert!((first[0] * first[1] - 0.5).abs() < 1e-13 && first[2].abs() < 1e-13);
    assert!((second[0].abs() - half).abs() < 1e-13 && (second[0] + second[1]).abs() < 1e-13);
}

#[test]
fn equal_eigenvalues_are_all_found() {
    let rows: Vec<Vec<f64>> = (0..5)
        .map(|row| {
            (0..5)
                .map(|column| if row == column { 2.0 } else { 0.0 })
                .collect()
        })
        .collect();
    let rows: Vec<&[f64]> = rows.iter().map(Vec::as_slice).collect();
    let found = of(&rows);
    assert_eq!(found.values.len(), 5);
    assert!(found.values.iter().all(|value| (value - 2.0).abs() < 1e-14));
    assert!(dot(&found.axes[0], &found.axes[1]).abs() < 1e-14);
}

#[test]
fn nothing_and_zeros() {
    let none = spectrum(0, 0, |_, _| {});
    assert_eq!((none.values.len(), none.axes[0].len()), (0, 0));
    let zeros = of(&[&[0.0, 0.0], &[0.0, 0.0]]);
    assert_eq!(zeros.values, [0.0; 2]);
    let one = of(&[&[7.0]]);
    assert_eq!(one.values, [7.0]);
    assert_eq!(one.axes[1], [0.0]);
}

#[test]
fn fewer_steps_find_the_same_axes_of_a_large_matrix() {
    // Eigenvalues 1, 0.8, 0.6, and 0.5 downwards: a turned diagonal I − 2uuᵀ.
    let size = 300;
    let diagonal = |index: usize| match index {
        0..3 => 1.0 - 0.2 * index as f64,
        _ => 0.5 - index as f64 * 1e-3,
    };
    let unit = 1.0 / (size as f64).sqrt();
    let turn = |vector: &mut [f64]| {
        let along = vector.iter().fold(0.0, |sum, value| sum + value * unit);
        for value in vector {
            *value -= 2.0 * along * unit;
        }
    };
    let found = spectrum(size, 120, |from, to| {
        to.copy_from_slice(from);
        turn(to);
        for (index, value) in to.iter_mut().enumerate() {
            *value *= diagonal(index);
        }
        turn(to);
    });
    assert!(found.values.len() < 120, "{} steps", found.values.len());
    for (axis, value) in [1.0, 0.8].into_iter().enumerate() {
        assert!((found.values[axis] - value).abs() < 1e-13);
        let mut turned = found.axes[axis].clone();
        turn(&mut turned);
        assert!((turned[axis].abs() - 1.0).abs() < 1e-13);
    }
}
