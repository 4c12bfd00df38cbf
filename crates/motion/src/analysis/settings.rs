//! What a person decides about one clip, and what a decision may be.

use core::fmt;

use crate::body::Role;
use crate::clip::Clip;
use crate::keypose::{Options, OptionsError};
use crate::world::{Unit, Up};

/// What an analysis is made with.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    pub decisions: Decisions,
    pub options: Options,
    pub frame_rate_hz: f64,
}

/// A person's decisions about one clip; none: as found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Decisions {
    /// Frames per second instead of what the file says.
    pub frame_rate_hz: Option<f64>,
    /// How many leading frames to leave out.
    pub leading_rest_frames: Option<usize>,
    /// The up axis.
    pub up: Option<Up>,
    /// The unit of length.
    pub unit: Option<Unit>,
    /// The height of the ground along the up axis, in file units.
    pub ground_height: Option<f64>,
    /// Which joints stand for which parts of the body; of two for one part the later.
    pub joints: Vec<JointDecision>,
}

/// A person's word that a joint is a part of a performer's body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct JointDecision {
    /// The performer, from 0.
    pub performer: usize,
    /// The part of the body.
    pub role: Role,
    /// The joint's index in the performer's skeleton.
    pub joint: usize,
}

/// Where a value is from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// The file or its motion.
    Found,
    /// Assumed for want of anything better.
    Default,
    /// A person.
    User,
}

impl Source {
    /// Its name in machine-readable output.
    pub fn name(self) -> &'static str {
        match self {
            Source::Found => "found",
            Source::Default => "default",
            Source::User => "user",
        }
    }
}

/// A decision or an option with a value that it cannot have.
#[derive(Clone, Debug, PartialEq)]
pub struct SettingsError {
    /// Its name, as the field of [`Decisions`] or [`crate::keypose::Options`].
    pub field: &'static str,
    /// Its value.
    pub found: String,
    /// What it may be.
    pub expected: &'static str,
}

impl fmt::Display for SettingsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} is {}; expected {}",
            self.field, self.found, self.expected
        )
    }
}

impl core::error::Error for SettingsError {}

impl From<OptionsError> for SettingsError {
    fn from(error: OptionsError) -> Self {
        Self {
            field: error.field,
            found: error.found.to_string(),
            expected: error.expected,
        }
    }
}

impl Decisions {
    /// The joints decided for one performer.
    pub fn joints_of(&self, performer: usize) -> Vec<(Role, usize)> {
        let of_performer = self.joints.iter().filter(|one| one.performer == performer);
        of_performer.map(|one| (one.role, one.joint)).collect()
    }

    /// Says which joint, if any, is not in the clip.
    ///
    /// # Errors
    /// The first joint or performer that the clip does not have.
    pub fn validate_joints(&self, clip: &Clip) -> Result<(), SettingsError> {
        let is_there = |one: &&JointDecision| {
            let performer = clip.performers.get(one.performer);
            performer.is_some_and(|found| one.joint < found.skeleton.joints.len())
        };
        match self.joints.iter().find(|one| !is_there(one)) {
            None => Ok(()),
            Some(JointDecision {
                performer,
                role,
                joint,
            }) => Err(SettingsError {
                field: "joints",
                found: format!("{} = joint {joint} of performer {performer}", role.name()),
                expected: "a joint of the clip",
            }),
        }
    }

    /// Says which other decision, if any, has a value that it cannot have.
    ///
    /// # Errors
    /// The frame rate, if it is not from 0.01 to 100 000; the ground, if it is not finite.
    pub fn validate(&self) -> Result<(), SettingsError> {
        let is_rate = |hz: &f64| (0.01..=100_000.0).contains(hz);
        let wrong = |field, value: f64, expected| SettingsError {
            field,
            found: value.to_string(),
            expected,
        };
        if let Some(hz) = self.frame_rate_hz.filter(|hz| !is_rate(hz)) {
            let expected = "a rate from 0.01 to 100000 frames per second";
            return Err(wrong("frame_rate_hz", hz, expected));
        }
        match self.ground_height.filter(|height| !height.is_finite()) {
            Some(height) => Err(wrong("ground_height", height, "a finite height")),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ground_that_is_nowhere_is_named() {
        let ground = |height| Decisions {
            ground_height: Some(height),
            ..Decisions::default()
        };
        for height in [f64::NAN, f64::NEG_INFINITY] {
            let error = ground(height).validate().unwrap_err();
            assert_eq!(error.field, "ground_height");
        }
        assert_eq!(ground(-3.5).validate(), Ok(()));
    }

    #[test]
    fn a_wrong_rate_is_named() {
        for hz in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let decisions = Decisions {
                frame_rate_hz: Some(hz),
                ..Decisions::default()
            };
            assert_eq!(decisions.validate().unwrap_err().field, "frame_rate_hz");
        }
        let decisions = Decisions {
            frame_rate_hz: Some(60.0),
            ..Decisions::default()
        };
        assert_eq!(decisions.validate(), Ok(()));
    }
}
