//! The filter against a solution in double-double arithmetic, and against its own definition.

use super::factors::Settled;
use super::*;
use test_support::Random;

/// A number of twice the precision: an unevaluated sum, the second part small beside the first
/// (T. J. Dekker, "A floating-point technique for extending the available precision", 1971).
#[derive(Clone, Copy, Debug)]
struct Double(f64, f64);

impl Double {
    fn sum(a: f64, b: f64) -> Self {
        let sum = a + b;
        let part = sum - a;
        Self(sum, (a - (sum - part)) + (b - part))
    }

    fn plus(self, other: Self) -> Self {
        let (high, low) = (Self::sum(self.0, other.0), Self::sum(self.1, other.1));
        let middle = Self::sum(high.0, high.1 + low.0);
        Self::sum(middle.0, middle.1 + low.1)
    }

    fn minus(self, other: Self) -> Self {
        self.plus(Self(-other.0, -other.1))
    }

    fn product(a: f64, b: f64) -> Self {
        let split = |value: f64| {
            let scaled = value * 134_217_729.0;
            let high = scaled - (scaled - value);
            (high, value - high)
        };
        let (product, (a_1, a_2), (b_1, b_2)) = (a * b, split(a), split(b));
        Self(
            product,
            ((a_1 * b_1 - product) + a_1 * b_2 + a_2 * b_1) + a_2 * b_2,
        )
    }

    fn times(self, other: Self) -> Self {
        let product = Self::product(self.0, other.0);
        Self::sum(product.0, product.1 + self.0 * other.1 + self.1 * other.0)
    }

    fn over(self, other: Self) -> Self {
        let first = self.0 / other.0;
        let rest = self.minus(other.times(Self(first, 0.0)));
        let second = rest.0 / other.0;
        let rest = rest.minus(other.times(Self(second, 0.0)));
        Self::sum(first, second).plus(Self(rest.0 / other.0, 0.0))
    }
}

const ZERO: Double = Double(0.0, 0.0);

/// `(K Kᵀ + I/λ) w = K y`, `x = y − Kᵀ w` by plain elimination, in double-double.
fn precise(signal: &[f64], lambda: f64) -> Vec<f64> {
    let y: Vec<Double> = signal.iter().map(|&value| Double(value, 0.0)).collect();
    let bend = |a: Double, b: Double, c: Double| a.minus(b).minus(b.minus(c));
    let unknowns = y.len() - 2;
    let diagonal = Double(6.0, 0.0).plus(Double(1.0, 0.0).over(Double(lambda, 0.0)));
    let mut pivots = vec![ZERO; unknowns];
    let mut beside = vec![ZERO; unknowns];
    let mut right = vec![ZERO; unknowns];
    for i in 0..unknowns {
        pivots[i] = diagonal;
        beside[i] = Double(-4.0, 0.0);
        right[i] = bend(y[i], y[i + 1], y[i + 2]);
        if i >= 2 {
            let factor = Double(1.0, 0.0).over(pivots[i - 2]);
            let upper = beside[i - 1];
            // Row i−2 holds (pivot, upper, 1); its `upper` is that of row i−1's lower side.
            pivots[i] = pivots[i].minus(factor);
            beside[i] = beside[i].minus(factor.times(upper));
            right[i] = right[i].minus(factor.times(right[i - 2]));
        }
        if i >= 1 {
            let factor = beside[i].over(pivots[i - 1]);
            pivots[i] = pivots[i].minus(factor.times(beside[i]));
            right[i] = right[i].minus(factor.times(right[i - 1]));
        }
    }
    let mut w = vec![ZERO; unknowns + 4];
    for i in (0..unknowns).rev() {
        let upper = if i + 1 < unknowns {
            beside[i + 1]
        } else {
            ZERO
        };
        let known = upper.times(w[i + 3]).plus(w[i + 4]);
        w[i + 2] = right[i].minus(known).over(pivots[i]);
    }
    (0..y.len())
        .map(|n| y[n].minus(bend(w[n + 2], w[n + 1], w[n])).0)
        .collect()
}

/// A smooth walk with some noise, as a coordinate of a joint may be.
fn signal(len: usize, seed: u64) -> Vec<f64> {
    let mut random = Random::new(seed);
    let mut place = 0.0;
    (0..len)
        .map(|n| {
            place += 0.02 * (random.unit() - 0.5);
            place + libm::sin(0.05 * n as f64) + 0.001 * random.unit()
        })
        .collect()
}

fn largest_error(found: &[f64], expected: &[f64]) -> f64 {
    let largest = expected
        .iter()
        .fold(0.0, |largest: f64, value| largest.max(value.abs()));
    let errors = found.iter().zip(expected).map(|(a, b)| (a - b).abs());
    errors.fold(0.0, f64::max) / largest
}

fn error_at(len: usize, cutoff_hz: f64, rate_hz: f64) -> f64 {
    let signal = signal(len, len as u64);
    let found = low_pass(&signal, cutoff_hz, rate_hz);
    largest_error(
        &found,
        &precise(&signal, lambda_of_cutoff(cutoff_hz, rate_hz)),
    )
}

#[test]
fn errors_stay_at_the_last_place() {
    // Required are 1e-11 at 0.1 Hz and 120 Hz, 1e-6 at 0.1 Hz and 1000 Hz.
    for (cutoff_hz, rate_hz) in [(10.0, 120.0), (0.1, 120.0), (0.1, 240.0), (0.1, 1000.0)] {
        for len in [3, 4, 5, 50, 317, 1000, 4500, 20_000] {
            let error = error_at(len, cutoff_hz, rate_hz);
            assert!(
                error <= 1e-15,
                "{cutoff_hz} Hz at {rate_hz} Hz, {len} samples: {error:e}"
            );
        }
    }
}

#[test]
fn rows_of_the_factors_tend_to_the_closed_form() {
    for (cutoff_hz, rate_hz) in [(59.0, 120.0), (10.0, 120.0), (0.1, 120.0), (0.1, 1000.0)] {
        let lambda = lambda_of_cutoff(cutoff_hz, rate_hz);
        let factors = Factors::new(100_000, [lambda]);
        assert_eq!(factors.head.len(), Settled::new(lambda).from);
        let last = factors.head[factors.head.len() - 1];
        // What rounding keeps a computed row off grows with the time constant in samples.
        let tolerance = 1e-15 * rate_hz / cutoff_hz;
        for (row, settled) in [
            (last.inverse_pivot, factors.settled.inverse_pivot),
            (last.below, factors.settled.below),
            (last.beside, factors.settled.beside),
        ] {
            assert!(
                (row[0] - settled[0]).abs() <= tolerance,
                "{cutoff_hz} Hz at {rate_hz} Hz"
            );
        }
    }
}

#[test]
fn the_precise_solution_solves_the_system_of_the_definition() {
    // (I + λ KᵀK) x = y, where doubles are enough to see it: a small λ.
    let signal = signal(60, 9);
    let lambda = 3.0;
    let x = precise(&signal, lambda);
    let bend: Vec<f64> = x.windows(3).map(|w| w[0] - 2.0 * w[1] + w[2]).collect();
    let at = |index: Option<usize>| {
        index
            .and_then(|index| bend.get(index))
            .copied()
            .unwrap_or(0.0)
    };
    for n in 0..60 {
        let transposed = at(Some(n)) - 2.0 * at(n.checked_sub(1)) + at(n.checked_sub(2));
        assert!((x[n] + lambda * transposed - signal[n]).abs() < 1e-13);
    }
}

#[test]
fn the_gain_at_the_cut_off_is_one_half() {
    let (rate_hz, cutoff_hz) = (120.0, 2.0);
    let wave = |n: usize| libm::cos(2.0 * PI * cutoff_hz / rate_hz * n as f64);
    let wave: Vec<f64> = (0..6001).map(wave).collect();
    let filtered = low_pass(&wave, cutoff_hz, rate_hz);
    assert!((filtered[3000] - 0.5).abs() < 1e-9);
}

#[test]
fn straight_lines_pass_and_short_signals_are_left_alone() {
    let line: Vec<f64> = (0..500).map(|n| 2.0 - 0.25 * f64::from(n)).collect();
    assert!(largest_error(&low_pass(&line, 0.1, 120.0), &line) < 1e-14);
    for short in [&[][..], &[4.0], &[4.0, 9.0]] {
        assert_eq!(low_pass(short, 1.0, 120.0), short);
    }
    assert_eq!(low_pass(&[1.0, 5.0, 2.0], 60.0, 120.0), [1.0, 5.0, 2.0]);
}

#[test]
fn lanes_and_steps_do_not_change_a_bit() {
    let signal = signal(700, 3);
    let cutoffs_hz = [8.0, 4.0, 1.0, 0.3, 0.2, 0.1, 0.15, 7.6];
    let filter = LaneFilter::new(700, cutoffs_hz.map(|hz| lambda_of_cutoff(hz, 120.0)));
    let mut solution = Solution::default();
    filter.start(&mut solution);
    let mut steps = 1;
    while !filter.advance(&Repeated(&signal), &mut solution, 97) {
        steps += 1;
    }
    assert_eq!(steps, 2100_usize.div_ceil(97));
    for (lane, cutoff_hz) in cutoffs_hz.into_iter().enumerate() {
        let alone = low_pass(&signal, cutoff_hz, 120.0);
        let in_lane: Vec<f64> = solution.rows().iter().map(|row| row[lane]).collect();
        assert_eq!(in_lane, alone);
    }
}

#[test]
fn a_signal_alone_is_filtered_in_steps_too() {
    let signal = signal(500, 4);
    for cutoff_hz in [0.5, 60.0, 1e5] {
        let mut run = LowPass::new(signal.len(), cutoff_hz, 120.0);
        while !run.advance(&signal, 61) {}
        assert_eq!(run.finish(), low_pass(&signal, cutoff_hz, 120.0));
    }
}
