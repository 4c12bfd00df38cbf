//! Decimals with more digits than an `f64` holds exactly: a significand and a negative power of
//! ten go in, the nearest number comes out.
//!
//! D. Lemire, *Number parsing at a gigabyte per second*, Software: Practice and Experience 51,
//! 2021, algorithm 1, for the powers of ten from 10⁻⁵⁴ to 10⁻¹, where no number is subnormal. That
//! the 128 bits of the reciprocal always suffice is shown by N. Mushtak and D. Lemire, *Fast number
//! parsing without fallback*, the same journal 53, 2023.

/// The powers that can be read: `size · 10^-power` for `power` from 1 to this.
pub const MOST_POWER: usize = 54;

/// The last power of which the reciprocal is rounded up; those of later ones are cut off.
const LAST_ROUNDED_UP: usize = 27;

/// For each power p from 0: ⌊2^(z+127) / 5^p⌋ with the least z for which 2^z ≥ 5^p, rounded up to
/// 5^27.
const RECIPROCALS: [u128; MOST_POWER + 1] = reciprocals();

const fn reciprocals() -> [u128; MOST_POWER + 1] {
    let mut table = [0; MOST_POWER + 1];
    let mut power = 1;
    let mut five: u128 = 1;
    while power <= MOST_POWER {
        five *= 5;
        table[power] = reciprocal(five) + (power <= LAST_ROUNDED_UP) as u128;
        power += 1;
    }
    table
}

/// Long division, bit by bit.
const fn reciprocal(divisor: u128) -> u128 {
    let bits = 128 - (divisor - 1).leading_zeros() + 127;
    let mut remainder: u128 = 1;
    let mut quotient: u128 = 0;
    let mut bit = 0;
    while bit < bits {
        remainder *= 2;
        quotient *= 2;
        if remainder >= divisor {
            remainder -= divisor;
            quotient += 1;
        }
        bit += 1;
    }
    quotient
}

/// `significand · 10^-power`, rounded to the nearest, ties to even; the significand is not zero
/// and `power` from 1 to [`MOST_POWER`].
pub fn divided(significand: u64, power: usize) -> f64 {
    let shift = significand.leading_zeros();
    let (high, low) = product(significand << shift, RECIPROCALS[power]);
    let upper = (high >> 63) as u32;
    // The 53 bits of the result and one more to round by.
    let below = upper + 9;
    let mut mantissa = high >> below;
    let is_tie = low <= 1 && power <= 4 && mantissa & 3 == 1 && mantissa << below == high;
    if is_tie {
        mantissa &= !1;
    }
    mantissa = (mantissa + (mantissa & 1)) >> 1;
    let mut exponent = binary_exponent(power) + i64::from(upper) - i64::from(shift);
    if mantissa >= 2 << 52 {
        mantissa = 1 << 52;
        exponent += 1;
    }
    f64::from_bits((mantissa & !(1 << 52)) | ((exponent + 1023) as u64) << 52)
}

/// The exponent of the highest bit of `2^63 · 10^-power`: ⌊-power · log₂ 10⌋ + 63.
fn binary_exponent(power: usize) -> i64 {
    ((-(power as i64) * 217_706) >> 16) + 63
}

/// The highest 128 of the 192 bits of a product, of which the lower half counts only where the
/// upper one leaves the rounding open.
fn product(factor: u64, reciprocal: u128) -> (u64, u64) {
    const OPEN: u64 = u64::MAX >> 55;
    let upper = u128::from(factor) * (reciprocal >> 64);
    let (mut high, mut low) = ((upper >> 64) as u64, upper as u64);
    if high & OPEN == OPEN {
        let lower = u128::from(factor) * (reciprocal & u128::from(u64::MAX));
        let (sum, is_over) = low.overflowing_add((lower >> 64) as u64);
        low = sum;
        high += u64::from(is_over);
    }
    (high, low)
}

#[cfg(test)]
mod tests {
    use super::*;
    use test_support::Random;

    fn check(significand: u64, power: usize) {
        let text = format!("{significand}e-{power}");
        let expected: f64 = text.parse().expect("a number");
        assert_eq!(
            divided(significand, power).to_bits(),
            expected.to_bits(),
            "{text}"
        );
    }

    #[test]
    fn every_power_rounds_to_the_nearest() {
        let mut random = Random::new(11);
        for _ in 0..10_000 {
            for power in 1..=MOST_POWER {
                check(random.next() >> random.below(64) | 1, power);
            }
        }
    }

    #[test]
    fn ties_and_their_neighbours_round_to_even() {
        let mut random = Random::new(12);
        for power in 1..=4_u32 {
            for _ in 0..20_000 {
                // An odd multiple of half a unit in the last place.
                let odd = (random.next() >> 11) | (1 << 52);
                for half in [2 * (odd >> 10) + 1, odd >> (3 * power)] {
                    let tie = half.checked_mul(5_u64.pow(power) << power.min(2));
                    for significand in tie.into_iter().flat_map(|tie| [tie - 1, tie, tie + 1]) {
                        check(significand, power as usize);
                    }
                }
            }
        }
    }

    #[test]
    fn the_least_and_the_largest_round() {
        for power in 1..=MOST_POWER {
            for significand in [1, 2, 5, 10, 1 << 53, (1 << 53) + 1, u64::MAX - 1, u64::MAX] {
                check(significand, power);
            }
        }
    }
}
