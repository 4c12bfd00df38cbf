//! A sample as someone else does it, for large sets: quicker or slower, with arms and trunk that go less or
//! farther, and only a part of it. In: a number. Out: the bytes of its BVH file, the same for the same number.

use crate::bvh_text;
use crate::rig::Rig;
use crate::sample::{Motion, Rate, Sample};

/// Least and most of what is varied. Shares are of what the sample has.
const TEMPO: [f64; 2] = [0.75, 1.3];
const ARMS: [f64; 2] = [0.5, 1.2];
const TRUNK: [f64; 2] = [0.5, 1.3];
const LENGTH_S: [f64; 2] = [1.5, 3.2];

/// What differs from the sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Variation {
    /// The motion, the rig and the rate.
    pub sample: Sample,
    /// Seconds of the sample in one second.
    pub tempo: f64,
    /// How far the arms go, as a share of how far they go in the sample.
    pub arms: f64,
    /// How far trunk and head bend, as a share of how far they bend in the sample.
    pub trunk: f64,
    /// Where in the sample it begins, in seconds of the sample.
    pub from_s: f64,
    /// Its length, in seconds.
    pub length_s: f64,
}

impl Variation {
    /// The variation with this number; motions take turns, all else is drawn.
    #[must_use]
    pub fn numbered(number: u64) -> Self {
        let mut draw = Draw(number);
        let motion = Motion::ALL[(number % Motion::ALL.len() as u64) as usize];
        let sample = Sample {
            motion,
            rig: Rig::ALL[draw.index(Rig::ALL.len())],
            rate: Rate::ALL[draw.index(Rate::ALL.len())],
        };
        let tempo = draw.between(TEMPO);
        let whole_s = motion.duration_s() / tempo;
        let length_s = draw.between(LENGTH_S).min(whole_s);
        Self {
            sample,
            tempo,
            arms: draw.between(ARMS),
            trunk: draw.between(TRUNK),
            from_s: draw.between([0.0, (whole_s - length_s) * tempo]),
            length_s,
        }
    }

    /// The bytes of the BVH file; the same on every platform.
    #[must_use]
    pub fn bvh(&self) -> Vec<u8> {
        let Sample { motion, rig, rate } = self.sample;
        let take = motion.take();
        let still = take.posture(0.0);
        let frames = libm::floor(self.length_s * rate.hz()) as usize + 1;
        let postures = (0..frames).map(|frame| {
            let time_s = self.from_s + self.tempo * frame as f64 / rate.hz();
            let posture = take.posture(time_s.min(take.duration_s()));
            posture.farther(&still, self.arms, self.trunk)
        });
        bvh_text::write(&rig.skeleton(), postures, rate.hz())
    }
}

/// Numbers as if drawn: SplitMix64 (Steele, Lea and Flood 2014).
struct Draw(u64);

impl Draw {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ (mixed >> 31)
    }

    fn index(&mut self, count: usize) -> usize {
        (self.next() % count as u64) as usize
    }

    fn between(&mut self, [least, most]: [f64; 2]) -> f64 {
        let share = (self.next() >> 11) as f64 / (1_u64 << 53) as f64;
        least + share * (most - least)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frames(bytes: &[u8]) -> usize {
        let text = std::str::from_utf8(bytes).expect("text");
        let count = text.lines().find_map(|line| line.strip_prefix("Frames: "));
        count.and_then(|count| count.parse().ok()).expect("frames")
    }

    #[test]
    fn the_same_number_gives_the_same_bytes_and_another_gives_others() {
        let bytes = |number| Variation::numbered(number).bvh();
        assert!(bytes(7) == bytes(7));
        assert!(bytes(7) != bytes(11));
    }

    #[test]
    fn numbers_stay_within_their_bounds() {
        for number in 0..400 {
            let variation = Variation::numbered(number);
            let whole_s = variation.sample.motion.duration_s();
            let end_s = variation.from_s + variation.tempo * variation.length_s;
            assert!(variation.from_s >= 0.0 && end_s <= whole_s + 1e-9);
            assert!((TEMPO[0]..=TEMPO[1]).contains(&variation.tempo));
            assert!(variation.length_s >= LENGTH_S[0]);
        }
    }

    #[test]
    fn as_in_the_sample_it_is_the_sample() {
        for motion in Motion::ALL {
            let rig = Rig::Hik;
            let rate = Rate::Hz30;
            let sample = Sample { motion, rig, rate };
            let whole = Variation {
                sample,
                tempo: 1.0,
                arms: 1.0,
                trunk: 1.0,
                from_s: 0.0,
                length_s: motion.duration_s(),
            };
            let slower = Variation {
                tempo: 0.5,
                length_s: 2.0 * motion.duration_s(),
                ..whole
            };
            let count = frames(&crate::bvh(&sample));
            assert_eq!(frames(&whole.bvh()), count);
            assert!(frames(&slower.bvh()).abs_diff(2 * count) <= 2);
        }
    }
}
