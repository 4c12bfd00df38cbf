//! One-way analysis of variance: numbers with their groups in, F and its upper tail out.
//!
//! `F = (SSB / (g−1)) / (SSW / (n−g))`; p is the probability of a greater F under the null
//! hypothesis, `I_{d₂ / (d₂ + d₁ F)}(d₂/2, d₁/2)` with the regularised incomplete beta function.

/// The F-test over the groups of a partition.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AnalysisOfVariance {
    /// The ratio of the variances; infinite where the groups have no spread of their own.
    pub f: f64,
    /// Degrees of freedom between the groups, g−1.
    pub df_between: usize,
    /// Degrees of freedom within the groups, n−g.
    pub df_within: usize,
    /// The probability of a greater F if the groups did not differ.
    pub p: f64,
}

/// The F-test over `values`, `group_of` naming each one's group, groups counted from 0.
///
/// None for fewer than two groups, for one value a group, and where all values are equal.
pub fn analysis_of_variance(values: &[f64], group_of: &[usize]) -> Option<AnalysisOfVariance> {
    let mut groups = vec![(0.0, 0usize); group_of.iter().max()? + 1];
    for (&value, &group) in values.iter().zip(group_of) {
        groups[group].0 += value;
        groups[group].1 += 1;
    }
    let used = groups.iter().filter(|group| group.1 > 0).count();
    if used < 2 || values.len() <= used {
        return None;
    }
    let (df_between, df_within) = (used - 1, values.len() - used);
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let (mut between, mut within) = (0.0, 0.0);
    for (&value, &group) in values.iter().zip(group_of) {
        let group_mean = groups[group].0 / groups[group].1 as f64;
        within += (value - group_mean) * (value - group_mean);
        between += (group_mean - mean) * (group_mean - mean);
    }
    let f = (between / df_between as f64) / (within / df_within as f64);
    let p = upper_tail_of_f(f, df_between as f64, df_within as f64);
    (!f.is_nan()).then_some(AnalysisOfVariance {
        f,
        df_between,
        df_within,
        p,
    })
}

/// P(F > f) for `df_1` and `df_2` degrees of freedom.
fn upper_tail_of_f(f: f64, df_1: f64, df_2: f64) -> f64 {
    // Both shares of 1 by a quotient of their own: 1 − x would lose the small one.
    let share_within = 1.0 / (1.0 + df_1 * f / df_2);
    let share_between = 1.0 / (1.0 + df_2 / (df_1 * f));
    incomplete_beta(df_2 / 2.0, df_1 / 2.0, share_within, share_between)
}

/// The regularised incomplete beta function I_x(a, b), with y = 1 − x.
///
/// Its continued fraction converges fast for x below (a+1)/(a+b+2); above, the other tail is
/// taken. Source: Abramowitz and Stegun, "Handbook of Mathematical Functions", 26.5.8.
fn incomplete_beta(a: f64, b: f64, x: f64, y: f64) -> f64 {
    if x <= 0.0 {
        return 0.0;
    }
    if y <= 0.0 {
        return 1.0;
    }
    let log_beta = libm::lgamma(a) + libm::lgamma(b) - libm::lgamma(a + b);
    let front = libm::exp(a * libm::log(x) + b * libm::log(y) - log_beta);
    if x <= (a + 1.0) / (a + b + 2.0) {
        front * beta_fraction(a, b, x) / a
    } else {
        1.0 - front * beta_fraction(b, a, y) / b
    }
}

/// The continued fraction of the incomplete beta function, by Lentz's method.
fn beta_fraction(a: f64, b: f64, x: f64) -> f64 {
    const TERMS_AT_MOST: usize = 10_000;
    let mut numerator = 1.0;
    let mut denominator = 1.0 / not_zero(1.0 - (a + b) * x / (a + 1.0));
    let mut fraction = denominator;
    for term in 1..TERMS_AT_MOST {
        let m = term as f64;
        let even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
        let odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
        let before = fraction;
        for coefficient in [even, odd] {
            denominator = 1.0 / not_zero(1.0 + coefficient * denominator);
            numerator = not_zero(1.0 + coefficient / numerator);
            fraction *= numerator * denominator;
        }
        if (fraction - before).abs() <= 1e-15 * fraction.abs() {
            break;
        }
    }
    fraction
}

/// Lentz's method must not divide by zero.
fn not_zero(value: f64) -> f64 {
    const TINY: f64 = 1e-300;
    if value.abs() < TINY { TINY } else { value }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values of mpmath with 40 digits: f, degrees of freedom, tail.
    #[test]
    fn tails_are_known_values() {
        for (f, df_1, df_2, expected) in F_TAILS {
            // The logarithms of the gamma function are exact to about 1e-15 of their size, 1e5.
            let found = upper_tail_of_f(f, df_1, df_2);
            assert!(
                (found - expected).abs() <= 1e-10 * expected,
                "{f} {df_1} {df_2}: {found}"
            );
        }
    }

    const F_TAILS: [(f64, f64, f64, f64); 9] = [
        (0.5, 1.0, 8.0, 0.499575894363259),
        (1.0, 3.0, 20.0, 0.41325191406246),
        (4.6, 1.0, 57.0, 0.03624752570774633),
        (12.25, 2.0, 11.0, 0.001590024537854),
        (2.5, 5.0, 4.0, 0.1977179016706332),
        (150.0, 1.0, 57.0, 1.338322881768985e-17),
        (900.0, 3.0, 400.0, 2.058749468436612e-177),
        (1.1, 7.0, 21600.0, 0.3598341351759562),
        (30.0, 1.0, 1.0, 0.1149641179510331),
    ];

    /// Table 1 of any textbook: three groups of three.
    #[test]
    fn a_small_table_by_hand() {
        let values = [1.0, 2.0, 3.0, 2.0, 3.0, 4.0, 6.0, 7.0, 8.0];
        let found = analysis_of_variance(&values, &[0, 0, 0, 1, 1, 1, 2, 2, 2]).unwrap();
        assert_eq!((found.df_between, found.df_within), (2, 6));
        assert!((found.f - 21.0).abs() < 1e-12);
        // With two degrees of freedom between: (1 + 2 F / d₂)^(−d₂/2) = 8⁻³.
        assert!((found.p - 1.0 / 512.0).abs() < 1e-15);
    }

    #[test]
    fn undefined_and_certain_cases() {
        assert_eq!(analysis_of_variance(&[], &[]), None);
        assert_eq!(analysis_of_variance(&[1.0, 2.0], &[0, 0]), None);
        assert_eq!(analysis_of_variance(&[1.0, 2.0], &[0, 1]), None);
        assert_eq!(analysis_of_variance(&[1.0, 1.0, 1.0], &[0, 1, 1]), None);
        let certain = analysis_of_variance(&[0.0, 1.0, 1.0], &[0, 1, 1]).unwrap();
        assert_eq!((certain.f, certain.p), (f64::INFINITY, 0.0));
    }
}
