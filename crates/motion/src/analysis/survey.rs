//! What is known of a clip once its poses are: body, world and feature, without keyposes. Enough to
//! compare the clip with others, in a part of the time of an analysis.

use super::placement::Placement;
use super::pose_run::Posed;
use super::settings::{Decisions, Source};
use crate::body::Body;
use crate::feature::ComparableFeature;
use crate::note::{Note, NoteKind};
use crate::rest::LeadingRest;
use crate::world::{Unit, Up};

/// With fewer frames there is no motion to compare.
const FEWEST_COMPARED: usize = 2;

/// What was found in one clip, short of its keyposes.
#[derive(Clone, Debug, PartialEq)]
pub struct Survey {
    /// Seconds from one frame to the next, as used.
    pub frame_time_s: f64,
    /// Where the frame time is from.
    pub frame_time_source: Source,
    /// One for each performer of the clip, in its order.
    pub performers: Vec<PerformerSurvey>,
}

/// What was found of one performer, short of the keyposes. Frames are those of the file, from 0.
#[derive(Clone, Debug, PartialEq)]
pub struct PerformerSurvey {
    /// Which joint is which.
    pub body: Body,
    /// Body height in file units.
    pub height: f64,
    /// The up axis and where it is from.
    pub up: (Up, Source),
    /// The height of the ground along the up axis, in file units.
    pub ground_height: f64,
    /// Where that is from.
    pub ground_source: Source,
    /// The unit of length and where it is from; none if unknown.
    pub unit: Option<(Unit, Source)>,
    /// How many frames before the motion were left out, and why.
    pub leading_rest: LeadingRest,
    /// How many frames come after them.
    pub frames: usize,
    /// Means and standard deviations of the posture variation, in squared body heights; none
    /// without frames or a human body.
    pub feature: Option<[f64; 12]>,
    /// What a comparison with other clips takes: that feature, the one across rigs, and the joints'
    /// parts of both; none where there is no feature, or one frame only.
    pub comparable: Option<ComparableFeature>,
    /// The yaw of a viewer whom the pelvis faces in the mean, as [`crate::figure::WidestSide`] counts.
    pub front_yaw_rad: f64,
    /// What was assumed and found out of the ordinary, short of what concerns keyposes.
    pub notes: Vec<Note>,
}

impl PerformerSurvey {
    /// The survey of one performer whose poses are there.
    pub(super) fn new(posed: Posed<'_>, decisions: &Decisions) -> Self {
        let Posed {
            body,
            placement,
            followed,
            surroundings,
        } = posed;
        let unit = placement.unit(body, decisions);
        Self {
            body: body.clone(),
            height: placement.frame.height,
            up: surroundings.up,
            ground_height: surroundings.ground_height,
            ground_source: surroundings.ground_source,
            unit,
            leading_rest: placement.leading_rest,
            frames: followed.track.frames(),
            feature: followed.comparable.as_ref().map(|found| found.recorded),
            comparable: followed
                .comparable
                .clone()
                .filter(|_| followed.track.frames() >= FEWEST_COMPARED),
            front_yaw_rad: surroundings.front_yaw_rad,
            notes: notes(posed, placement, unit.is_none()),
        }
    }
}

fn notes(posed: Posed<'_>, placement: &Placement, is_unit_unknown: bool) -> Vec<Note> {
    let mut notes = posed.body.notes.clone();
    notes.extend(placement.notes());
    notes.extend(posed.surroundings.note());
    if is_unit_unknown {
        notes.push(Note::new(NoteKind::UnitUnknown, Vec::new()));
    }
    notes.extend_from_slice(&posed.followed.jumps);
    notes
}
