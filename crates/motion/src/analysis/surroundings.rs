//! The world around a performer: how its body stands goes in; up, the ground and the side that it
//! faces come out.

use super::facing;
use super::settings::{Decisions, Source};
use crate::body::{Body, Footing, PelvisFrame, TableBuilder};
use crate::clip::Clip;
use crate::note::{Note, NoteKind};
use crate::world::{self, Up};

/// Up, ground and front of one performer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surroundings {
    pub up: (Up, Source),
    pub ground_height: f64,
    pub ground_source: Source,
    pub front_yaw_rad: f64,
}

impl Surroundings {
    /// The surroundings of one performer (from 0) with its pelvis frame.
    pub fn new(
        clip: &Clip,
        performer: usize,
        body: &Body,
        footing: &Footing,
        frame: &PelvisFrame,
        decisions: &Decisions,
    ) -> Self {
        let up = up(footing, decisions);
        let found = || {
            (
                ground_height(clip, performer, body, footing, up.0),
                Source::Found,
            )
        };
        let decided = decisions.ground_height.map(|height| (height, Source::User));
        let (ground_height, ground_source) = decided.unwrap_or_else(found);
        Self {
            ground_height,
            ground_source,
            front_yaw_rad: facing::front_yaw_rad(clip, performer, frame, up.0),
            up,
        }
    }

    /// What was assumed.
    pub fn note(&self) -> Option<Note> {
        let is_assumed = self.up.1 == Source::Default;
        is_assumed.then(|| Note::new(NoteKind::UpAssumed, Vec::new()))
    }
}

/// The ground of the motion; of a clip without one, that of its skeleton.
fn ground_height(clip: &Clip, performer: usize, body: &Body, footing: &Footing, up: Up) -> f64 {
    if clip.frames > 0 {
        return world::ground_height(footing, up);
    }
    let skeleton = TableBuilder::new(clip, performer, body).rest();
    world::ground_height(&skeleton.footing, up)
}

fn up(footing: &Footing, decisions: &Decisions) -> (Up, Source) {
    match (decisions.up, world::up_axis(footing)) {
        (Some(up), _) => (up, Source::User),
        (None, Some(up)) => (up, Source::Found),
        (None, None) => (Up::PLUS_Y, Source::Default),
    }
}
