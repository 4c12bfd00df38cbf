//! A sample: which motion, in which rig, at which rate; its bytes and its true keyposes.

use crate::bvh_text;
use crate::dance::Dance;
use crate::rig::Rig;
use crate::run::Run;
use crate::take::Take;
use crate::walk::Walk;

/// What is danced, walked or run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// Thirteen held poses on alternating supports.
    SlowDance,
    /// The slow dance at tempo 0.85 and amplitude 0.8, the trunk 8° forward, trembling at 3 to 5 Hz.
    TiredDance,
    /// From standing, ten steps; the keyposes are the heel strikes.
    Walk,
    /// Twelve steps of a run that is under way; the keyposes are the middles of the flights.
    Run,
}

impl Motion {
    /// Every motion.
    pub const ALL: [Self; 4] = [Self::SlowDance, Self::TiredDance, Self::Walk, Self::Run];

    /// Short name in lower case, used in ids and file names.
    pub fn id(self) -> &'static str {
        match self {
            Self::SlowDance => "slow-dance",
            Self::TiredDance => "tired-dance",
            Self::Walk => "walk",
            Self::Run => "run",
        }
    }

    /// Its length.
    pub(crate) fn duration_s(self) -> f64 {
        self.take().duration_s()
    }

    pub(crate) fn take(self) -> Box<dyn Take> {
        match self {
            Self::SlowDance => Box::new(Dance::slow()),
            Self::TiredDance => Box::new(Dance::tired()),
            Self::Walk => Box::new(Walk::new()),
            Self::Run => Box::new(Run::new()),
        }
    }
}

/// Frames per second.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rate {
    /// 30 frames per second.
    Hz30,
    /// 60 frames per second.
    Hz60,
    /// 120 frames per second.
    Hz120,
}

impl Rate {
    /// Every rate.
    pub const ALL: [Self; 3] = [Self::Hz30, Self::Hz60, Self::Hz120];

    /// Frames per second.
    pub fn hz(self) -> f64 {
        match self {
            Self::Hz30 => 30.0,
            Self::Hz60 => 60.0,
            Self::Hz120 => 120.0,
        }
    }
}

/// A true keypose: frames of the file, from 0, both included; equal for an instant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mark {
    /// First frame.
    pub from: usize,
    /// Last frame.
    pub to: usize,
}

/// A motion in a rig at a rate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sample {
    /// The motion.
    pub motion: Motion,
    /// The rig.
    pub rig: Rig,
    /// The rate.
    pub rate: Rate,
}

impl Sample {
    /// All combinations.
    pub fn all() -> impl Iterator<Item = Self> {
        Motion::ALL.into_iter().flat_map(|motion| {
            Rig::ALL.into_iter().flat_map(move |rig| {
                Rate::ALL
                    .into_iter()
                    .map(move |rate| Self { motion, rig, rate })
            })
        })
    }

    /// File name without suffix, such as `slow-dance-hik-120`.
    pub fn id(&self) -> String {
        format!("{}-{}-{}", self.motion.id(), self.rig.id(), self.rate.hz())
    }
}

/// The bytes of the BVH file; the same on every platform.
pub fn bvh(sample: &Sample) -> Vec<u8> {
    let rate_hz = sample.rate.hz();
    let take = sample.motion.take();
    let frames = libm::floor(take.duration_s() * rate_hz) as usize + 1;
    let postures = (0..frames).map(|frame| take.posture(frame as f64 / rate_hz));
    bvh_text::write(&sample.rig.skeleton(), postures, rate_hz)
}

/// The true keyposes in order of time: the holds of the dances, the heel strikes of the walk, the
/// middles of the flights of the run.
pub fn true_keyposes(sample: &Sample) -> Vec<Mark> {
    let keyposes_s = sample.motion.take().keyposes_s();
    keyposes_s
        .iter()
        .map(|span_s| mark(span_s, sample.rate.hz()))
        .collect()
}

/// An instant is its nearest frame, a span the frames inside it.
fn mark([from_s, to_s]: &[f64; 2], rate_hz: f64) -> Mark {
    let [from, to] = [from_s * rate_hz, to_s * rate_hz];
    if from == to {
        let frame = libm::round(from) as usize;
        return Mark {
            from: frame,
            to: frame,
        };
    }
    Mark {
        from: libm::ceil(from - 1e-9) as usize,
        to: libm::floor(to + 1e-9) as usize,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(text: &str) -> Vec<&str> {
        text.lines()
            .skip_while(|line| *line != "MOTION")
            .skip(3)
            .collect()
    }

    #[test]
    fn every_row_is_as_wide_as_the_channels() {
        for sample in Sample::all().filter(|sample| sample.rate == Rate::Hz30) {
            let text = String::from_utf8(bvh(&sample)).expect("text");
            let channels: usize = text
                .lines()
                .filter_map(|line| line.trim().strip_prefix("CHANNELS "))
                .map(|rest| {
                    rest.split_once(' ')
                        .map_or(0, |(n, _)| n.parse().unwrap_or(0))
                })
                .sum();
            let frames = text.lines().find_map(|line| line.strip_prefix("Frames: "));
            assert_eq!(frames, Some(rows(&text).len().to_string().as_str()));
            for row in rows(&text) {
                assert_eq!(row.split(' ').count(), channels, "{}", sample.id());
                assert!(
                    row.split(' ')
                        .all(|value| value.parse().is_ok_and(f64::is_finite))
                );
            }
            assert_eq!(text.matches('{').count(), text.matches('}').count());
        }
    }

    #[test]
    fn channels_do_not_jump() {
        for sample in Sample::all().filter(|sample| sample.rate == Rate::Hz120) {
            let text = String::from_utf8(bvh(&sample)).expect("text");
            let values = |row: &str| -> Vec<f64> {
                row.split(' ')
                    .map(|value| value.parse().expect("number"))
                    .collect()
            };
            let values: Vec<_> = rows(&text).into_iter().map(values).collect();
            for (frame, pair) in values.windows(2).enumerate() {
                for (a, b) in pair[0].iter().zip(&pair[1]) {
                    assert!(
                        (a - b).abs() < 90.0,
                        "{} at frame {frame}: {a} {b}",
                        sample.id()
                    );
                }
            }
        }
    }

    #[test]
    fn the_same_bytes_twice() {
        for sample in Sample::all().filter(|sample| sample.rate == Rate::Hz30) {
            assert!(bvh(&sample) == bvh(&sample));
        }
    }

    #[test]
    fn marks_are_in_order_and_inside_the_clip() {
        for sample in Sample::all() {
            let text = String::from_utf8(bvh(&sample)).expect("text");
            let marks = true_keyposes(&sample);
            assert!(marks.iter().all(|mark| mark.from <= mark.to));
            assert!(marks.windows(2).all(|pair| pair[0].to < pair[1].from));
            assert!(marks[0].from > 0 && marks[marks.len() - 1].to + 1 < rows(&text).len());
        }
    }
}
