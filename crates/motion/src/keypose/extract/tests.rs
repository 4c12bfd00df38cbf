//! The extraction as a whole: its steps, its series, and input that no motion has.

use super::*;
use crate::keypose::SelectionRule;
use test_support::Random;

/// A gait-like speed: four strides, each slow at its start, and a tremor.
fn strides(len: usize) -> Vec<f64> {
    let turn = |n: usize, period: f64| libm::cos(2.0 * std::f64::consts::PI * n as f64 / period);
    (0..len)
        .map(|n| 3.0 - turn(n, 60.0) + 0.05 * turn(n, 13.0))
        .collect()
}

fn extracted(speed: &[f64]) -> Extraction {
    extract(speed, 120.0, &Options::default()).unwrap()
}

#[test]
fn the_slow_moments_of_strides_are_keyposes() {
    let found = extracted(&strides(331));
    // The speed is least at 0, 60, 120 … ; an end is never a minimum.
    let keyposes = found.keyposes();
    assert_eq!(keyposes.len(), 5, "{keyposes:?}");
    for (keypose, stride) in keyposes.iter().zip([60, 120, 180, 240, 300]) {
        assert!(keypose.abs_diff(stride) <= 4, "{keyposes:?}");
    }
}

#[test]
fn steps_of_any_size_give_the_same_bits() {
    let speed = strides(500);
    let whole = extracted(&speed);
    for budget in [1, 37, 1000] {
        let mut extractor = Extractor::new(speed.clone(), 120.0, &Options::default()).unwrap();
        let mut last = 0.0;
        while !extractor.advance(budget) {
            assert!(extractor.progress() >= last);
            last = extractor.progress();
        }
        assert_eq!(extractor.progress(), 1.0);
        assert_eq!(extractor.finish(), whole);
    }
}

#[test]
fn every_survivor_belongs_to_one_candidate() {
    let mut random = Random::new(8);
    let speed: Vec<f64> = (0..2000).map(|_| 1.0 + random.unit()).collect();
    let found = extracted(&speed);
    assert_eq!(found.traces.offsets.len(), found.candidates.len() + 1);
    assert_eq!(found.intensity, found.traces.intensity());
    for scale in 0..found.scales_hz.len() {
        let at_scale = |candidate| found.traces.of(candidate).0.get(scale).copied();
        let frames: Vec<usize> = (0..found.candidates.len()).filter_map(at_scale).collect();
        assert!(
            frames.windows(2).all(|pair| pair[0] < pair[1]),
            "order is kept at {scale}"
        );
    }
}

#[test]
fn the_order_by_intensity_falls() {
    let found = extracted(&strides(331));
    let order = found.by_intensity();
    assert!(
        order
            .windows(2)
            .all(|pair| found.intensity[pair[0]] >= found.intensity[pair[1]])
    );
    assert_eq!(order.len(), found.candidates.len());
}

#[test]
fn scales_at_half_the_rate_are_left_out() {
    let found = extract(&strides(331), 12.0, &Options::default()).unwrap();
    // 8, 7.6, 7.22, 6.859, 6.516 and 6.190 Hz; 5.88 Hz is below half of 12.
    assert_eq!(found.scales_left_out, 6);
    assert!(found.scales_hz[0] < 6.0);
    let none = extract(&strides(331), 0.3, &Options::default()).unwrap();
    assert_eq!((none.scales_hz.len(), none.scales_left_out), (0, 72));
    assert!(none.keyposes().is_empty());
}

#[test]
fn nothing_moves_nothing_is_found() {
    for speed in [&[][..], &[1.0], &[2.0, 1.0], &[0.0; 500], &[3.0; 500]] {
        let found = extracted(speed);
        assert!(found.candidates.is_empty() && found.keyposes().is_empty());
        assert_eq!((found.traces.offsets, found.scales_hz), (vec![0], vec![]));
    }
}

#[test]
fn numbers_that_no_motion_has_do_no_harm() {
    let mut random = Random::new(9);
    let odd = [
        f64::NAN,
        f64::INFINITY,
        -1.0,
        0.0,
        1e308,
        5e-324,
        -f64::INFINITY,
        f64::MAX,
    ];
    for round in 0..200 {
        let share = 1 + random.below(100);
        let speed: Vec<f64> = (0..60)
            .map(|_| {
                if random.below(share) == 0 {
                    odd[random.below(8)]
                } else {
                    random.unit()
                }
            })
            .collect();
        let rates_hz = [
            120.0,
            0.25,
            2000.0,
            0.0,
            -1.0,
            f64::NAN,
            f64::INFINITY,
            1e-300,
        ];
        let rules = [
            SelectionRule::Automatic,
            SelectionRule::Literal,
            SelectionRule::EvenSplit,
        ];
        let options = Options {
            selection: rules[round % 3],
            ..Options::default()
        };
        let found = extract(&speed, rates_hz[random.below(8)], &options).unwrap();
        assert!(found.keyposes().len() <= speed.len());
    }
}

#[test]
fn an_option_out_of_range_is_refused() {
    let options = Options {
        scale_min_hz: 0.0,
        ..Options::default()
    };
    let error = extract(&[1.0, 0.0, 1.0], 120.0, &options).unwrap_err();
    assert_eq!(error.field, "scale_min_hz");
}
