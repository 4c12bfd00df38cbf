//! In: a share of a move, or the conditions at its two ends. Out: the position on the way.
//!
//! People move so that jerk is small (Flash and Hogan 1985): between two rests that is the quintic
//! 10x³ − 15x⁴ + 6x⁵.

/// Share of the way covered at the share `x` of the time; 0 before the move, 1 after it.
pub fn minimum_jerk(x: f64) -> f64 {
    let x = x.clamp(0.0, 1.0);
    x * x * x * (10.0 + x * (-15.0 + 6.0 * x))
}

/// A detour: 0 at both ends with speed and acceleration 0, 1 in the middle.
pub fn detour(x: f64) -> f64 {
    let x = x.clamp(0.0, 1.0);
    let product = 4.0 * x * (1.0 - x);
    product * product * product
}

/// Position, velocity per second and acceleration per second² at one end of a move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End {
    pub position: f64,
    pub velocity: f64,
    pub acceleration: f64,
}

impl End {
    pub const fn at_rest(position: f64) -> Self {
        Self::moving(position, 0.0)
    }

    pub const fn moving(position: f64, velocity: f64) -> Self {
        Self {
            position,
            velocity,
            acceleration: 0.0,
        }
    }
}

/// The polynomial of degree 5 with given conditions at both ends.
#[derive(Clone, Copy, Debug)]
pub struct Quintic {
    from_s: f64,
    coefficients: [f64; 6],
}

impl Quintic {
    pub fn new(from_s: f64, from: End, to_s: f64, to: End) -> Self {
        let d = to_s - from_s;
        let [p, v, a] = [from.position, from.velocity, from.acceleration];
        let rest = to.position - p - v * d - 0.5 * a * d * d;
        let slope = to.velocity - v - a * d;
        let bend = to.acceleration - a;
        let coefficients = [
            p,
            v,
            0.5 * a,
            (10.0 * rest - 4.0 * slope * d + 0.5 * bend * d * d) / (d * d * d),
            (-15.0 * rest + 7.0 * slope * d - bend * d * d) / (d * d * d * d),
            (6.0 * rest - 3.0 * slope * d + 0.5 * bend * d * d) / (d * d * d * d * d),
        ];
        Self {
            from_s,
            coefficients,
        }
    }

    pub fn at(&self, time_s: f64) -> f64 {
        let t = time_s - self.from_s;
        self.coefficients
            .iter()
            .rev()
            .fold(0.0, |sum, c| sum * t + c)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEP: f64 = 1e-4;

    fn slope(f: impl Fn(f64) -> f64, x: f64) -> f64 {
        (f(x + STEP) - f(x - STEP)) / (2.0 * STEP)
    }

    #[test]
    fn minimum_jerk_rests_at_both_ends() {
        assert_eq!(
            [minimum_jerk(0.0), minimum_jerk(0.5), minimum_jerk(1.0)],
            [0.0, 0.5, 1.0]
        );
        assert_eq!([minimum_jerk(-1.0), minimum_jerk(2.0)], [0.0, 1.0]);
        for end in [0.0, 1.0] {
            assert!(slope(minimum_jerk, end).abs() < 1e-6);
            assert!(slope(|x| slope(minimum_jerk, x), end).abs() < 0.02);
        }
        assert!((slope(minimum_jerk, 0.5) - 1.875).abs() < 1e-6);
    }

    #[test]
    fn a_detour_leaves_and_returns() {
        assert_eq!([detour(0.0), detour(0.5), detour(1.0)], [0.0, 1.0, 0.0]);
        assert!(slope(detour, 0.0).abs() < 1e-6);
    }

    #[test]
    fn a_quintic_meets_its_ends() {
        let from = End {
            position: 1.0,
            velocity: -2.0,
            acceleration: 3.0,
        };
        let to = End {
            position: -0.5,
            velocity: 4.0,
            acceleration: -1.0,
        };
        let q = Quintic::new(0.3, from, 1.1, to);
        for (time_s, end) in [(0.3, from), (1.1, to)] {
            assert!((q.at(time_s) - end.position).abs() < 1e-12);
            assert!((slope(|t| q.at(t), time_s) - end.velocity).abs() < 1e-5);
            let acceleration = slope(|t| slope(|u| q.at(u), t), time_s);
            assert!((acceleration - end.acceleration).abs() < 1e-4);
        }
    }
}
