//! Every parameter of the extraction of keyposes, its default, and what values it may have.

use std::fmt;

/// Most time scales that an extraction may have.
const SCALES_AT_MOST: usize = 1000;

/// How candidates are told to be keyposes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SelectionRule {
    /// Ward's clusters with Mojena's rule and a zero reference; gaps where that rule cannot speak.
    #[default]
    Automatic,
    /// The published rule to the letter: where Mojena's rule does not fire there is one cluster.
    Literal,
    /// The two-class split of the intensities and one zero with the least squares within.
    EvenSplit,
}

impl SelectionRule {
    /// Every rule.
    pub const ALL: [SelectionRule; 3] = [
        SelectionRule::Automatic,
        SelectionRule::Literal,
        SelectionRule::EvenSplit,
    ];

    /// Its name in machine-readable output.
    pub fn name(self) -> &'static str {
        match self {
            SelectionRule::Automatic => "automatic",
            SelectionRule::Literal => "literal",
            SelectionRule::EvenSplit => "even-split",
        }
    }
}

/// The parameters of [`extract`](crate::keypose::extract()) and of the speed before it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Cut-off of the coordinates before the speed, in Hz. Default 10.
    pub low_pass_hz: f64,
    /// Cut-off of the trend drawn beside the speed, in Hz. Default 0.5.
    pub trend_hz: f64,
    /// The finest time scale, in Hz. Default 8.
    pub scale_max_hz: f64,
    /// No time scale is below this, in Hz. Default 0.2.
    pub scale_min_hz: f64,
    /// Ratio of a time scale to the one before. Default 0.95.
    pub scale_ratio: f64,
    /// Minima shallower than this part of the greatest speed do not count. Default 1e-6.
    pub depth_floor: f64,
    /// Standard deviations above the mean at which a merge height ends the merging. Default 2.75.
    pub mojena_k: f64,
    /// How candidates are told to be keyposes. Default [`SelectionRule::Automatic`].
    pub selection: SelectionRule,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            low_pass_hz: 10.0,
            trend_hz: 0.5,
            scale_max_hz: 8.0,
            scale_min_hz: 0.2,
            scale_ratio: 0.95,
            depth_floor: 1e-6,
            mojena_k: 2.75,
            selection: SelectionRule::Automatic,
        }
    }
}

/// An option with a value that it cannot have.
#[derive(Clone, Debug, PartialEq)]
pub struct OptionsError {
    /// The option's name, as the field of [`Options`].
    pub field: &'static str,
    /// Its value.
    pub found: f64,
    /// What it may be.
    pub expected: &'static str,
}

impl fmt::Display for OptionsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} is {}; expected {}",
            self.field, self.found, self.expected
        )
    }
}

impl std::error::Error for OptionsError {}

impl Options {
    /// Says which option, if any, has a value that it cannot have.
    ///
    /// # Errors
    /// The first such option, in the order of the fields.
    pub fn validate(&self) -> Result<(), OptionsError> {
        let frequency = "a frequency from 0.01 to 100000 Hz";
        check("low_pass_hz", self.low_pass_hz, is_frequency, frequency)?;
        check("trend_hz", self.trend_hz, is_frequency, frequency)?;
        check("scale_max_hz", self.scale_max_hz, is_frequency, frequency)?;
        check("scale_min_hz", self.scale_min_hz, is_frequency, frequency)?;
        let below_max = |hz| hz <= self.scale_max_hz;
        check(
            "scale_min_hz",
            self.scale_min_hz,
            below_max,
            "at most scale_max_hz",
        )?;
        let is_ratio = |ratio| ratio > 0.0 && ratio < 1.0;
        check(
            "scale_ratio",
            self.scale_ratio,
            is_ratio,
            "a number above 0 and below 1",
        )?;
        let is_countable = |_| self.scale_count() <= SCALES_AT_MOST;
        check(
            "scale_ratio",
            self.scale_ratio,
            is_countable,
            "a ratio with at most 1000 scales",
        )?;
        let is_part = |part| (0.0..1.0).contains(&part);
        check(
            "depth_floor",
            self.depth_floor,
            is_part,
            "a number from 0 to below 1",
        )?;
        let is_factor = |factor: f64| factor >= 0.0 && factor.is_finite();
        check("mojena_k", self.mojena_k, is_factor, "a number from 0")
    }

    /// The time scales from fine to coarse, in Hz: `f_max · ratio^i` down to the last that is not
    /// below `f_min`. Scales beyond the limit of [`Options::validate`] are left out.
    pub fn scales_hz(&self) -> Vec<f64> {
        let scale = |index: usize| self.scale_max_hz * libm::pow(self.scale_ratio, index as f64);
        (0..SCALES_AT_MOST)
            .map(scale)
            .take_while(|&hz| hz >= self.scale_min_hz)
            .collect()
    }

    fn scale_count(&self) -> usize {
        let range = libm::log(self.scale_min_hz / self.scale_max_hz);
        (range / libm::log(self.scale_ratio)) as usize + 1
    }
}

fn is_frequency(hz: f64) -> bool {
    (0.01..=100_000.0).contains(&hz)
}

fn check(
    field: &'static str,
    found: f64,
    holds: impl Fn(f64) -> bool,
    expected: &'static str,
) -> Result<(), OptionsError> {
    match holds(found) {
        true => Ok(()),
        false => Err(OptionsError {
            field,
            found,
            expected,
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn defaults_are_valid_and_give_72_scales() {
        let options = Options::default();
        assert_eq!(options.validate(), Ok(()));
        let scales = options.scales_hz();
        assert_eq!(scales.len(), 72);
        assert_eq!(scales[0], 8.0);
        assert!(scales[71] >= 0.2 && scales[71] * 0.95 < 0.2);
    }

    #[test]
    fn a_wrong_value_is_named() {
        let message = |options: Options| options.validate().unwrap_err().to_string();
        let base = Options::default();
        assert_eq!(
            message(Options {
                scale_ratio: 1.0,
                ..base
            }),
            "scale_ratio is 1; expected a number above 0 and below 1"
        );
        assert_eq!(
            message(Options {
                scale_ratio: 0.9999,
                ..base
            }),
            "scale_ratio is 0.9999; expected a ratio with at most 1000 scales"
        );
        assert_eq!(
            message(Options {
                scale_min_hz: 9.0,
                ..base
            }),
            "scale_min_hz is 9; expected at most scale_max_hz"
        );
        assert_eq!(
            message(Options {
                low_pass_hz: f64::NAN,
                ..base
            }),
            "low_pass_hz is NaN; expected a frequency from 0.01 to 100000 Hz"
        );
        assert_eq!(
            message(Options {
                depth_floor: -1.0,
                ..base
            }),
            "depth_floor is -1; expected a number from 0 to below 1"
        );
        assert_eq!(
            message(Options {
                mojena_k: f64::INFINITY,
                ..base
            }),
            "mojena_k is inf; expected a number from 0"
        );
    }
}
