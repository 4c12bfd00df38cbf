//! What slows down at a moment: the speeds of the body's parts and a frame go in, how each compares
//! with the time around it comes out.
//!
//! `100 · (w(n) / mean of w over the frames within ± 0.5 s, cut at the ends, − 1)` percent.

use crate::body::BODY_PARTS;

/// How far the time around a moment reaches, in seconds.
const AROUND_S: f64 = 0.5;

/// Frame times are written with few digits: a frame that lies this part of one beyond still counts.
const FRAME_SLACK: f64 = 0.01;

/// A mean below this, in body heights per second, is no speed.
const NO_SPEED: f64 = 1e-9;

/// The change of each part in percent; none where it does not move in the time around.
pub type PartChange = [Option<f64>; BODY_PARTS];

/// The change of each part at a frame of `parts` ([`crate::speed::MotionSpeed::parts`]).
pub fn part_change(parts: &[[f64; BODY_PARTS]], frame: usize, frame_rate_hz: f64) -> PartChange {
    let reach = (AROUND_S * frame_rate_hz + FRAME_SLACK) as usize;
    let last = frame
        .saturating_add(reach)
        .min(parts.len().saturating_sub(1));
    let around = &parts[frame.saturating_sub(reach)..=last];
    core::array::from_fn(|part| {
        let sum: f64 = around.iter().map(|speeds| speeds[part]).sum();
        let mean = sum / around.len() as f64;
        (mean >= NO_SPEED).then(|| 100.0 * (parts[frame][part] / mean - 1.0))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_moment_is_held_against_half_a_second_on_either_side() {
        let mut parts = vec![[2.0, 1.0, 0.0, 1.0, 1.0]; 40];
        parts[20] = [0.0, 3.0, 0.0, 1.0, 1.0];
        parts[9][3] = 1e6;
        // ± 10 frames: 21 of them, those beyond do not count.
        let found = part_change(&parts, 20, 20.0);
        assert_eq!(found[0], Some(-100.0));
        let mean = 23.0 / 21.0;
        assert!((found[1].unwrap() - 100.0 * (3.0 / mean - 1.0)).abs() < 1e-12);
        assert_eq!(found[2], None);
        assert_eq!(found[3], Some(0.0));
    }

    #[test]
    fn the_time_around_ends_with_the_clip() {
        let parts: Vec<[f64; 5]> = [4.0, 2.0, 3.0].map(|speed| [speed; 5]).to_vec();
        let first = part_change(&parts, 0, 2.0)[0].unwrap();
        assert!((first - 100.0 * (4.0 / 3.0 - 1.0)).abs() < 1e-12);
        let last = part_change(&parts, 2, 1000.0)[0].unwrap();
        assert!(last.abs() < 1e-12);
    }

    #[test]
    fn a_rate_from_a_rounded_frame_time_reaches_as_far() {
        let mut parts = vec![[1.0; 5]; 41];
        parts[5] = [16.0; 5];
        // 1 / 0.0333334: half a second is 14.99997 frames.
        let found = part_change(&parts, 20, 1.0 / 0.033_333_4)[0].unwrap();
        assert!((found - 100.0 * (1.0 / (46.0 / 31.0) - 1.0)).abs() < 1e-9);
    }
}
