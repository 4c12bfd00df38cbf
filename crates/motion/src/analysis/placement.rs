//! Where the body stands: the poses of one performer go in; its pelvis frame, the world around it
//! and the frames to leave out come out.

use super::facing;
use super::settings::{Decisions, Source};
use crate::body::{Body, PelvisFrame, PoseTable, TableBuilder};
use crate::clip::Clip;
use crate::note::{Note, NoteKind};
use crate::rest::{self, LeadingRest, RestReason};
use crate::world::{self, Unit, Up};

/// What is known of one performer before its speed.
#[derive(Clone, Debug, PartialEq)]
pub struct Placement {
    pub frame: PelvisFrame,
    pub up: (Up, Source),
    pub ground_height: f64,
    pub leading_rest: LeadingRest,
    pub front_yaw_rad: f64,
}

impl Placement {
    /// The placement of one performer (from 0) whose poses are all in `table`; `frame` where it is
    /// known already.
    pub fn new(
        clip: &Clip,
        performer: usize,
        body: &Body,
        table: &PoseTable,
        decisions: &Decisions,
        frame: Option<PelvisFrame>,
    ) -> Self {
        let frame_from = |first| PelvisFrame::new(clip, performer, body, table, first);
        let mut found = frame.unwrap_or_else(|| frame_from(0));
        let leading_rest = leading_rest(body, table, &found, decisions);
        if leading_rest.frames > 0 && !found.is_root {
            found = frame_from(leading_rest.frames);
        }
        let up = up(table, decisions);
        Self {
            ground_height: ground_height(clip, performer, body, table, up.0),
            front_yaw_rad: facing::front_yaw_rad(clip, performer, &found, up.0),
            up,
            leading_rest,
            frame: found,
        }
    }

    /// What was assumed.
    pub fn notes(&self) -> Vec<Note> {
        let mut notes = self.frame.notes.clone();
        notes.extend(self.leading_rest.note());
        if self.up.1 == Source::Default {
            notes.push(Note::new(NoteKind::UpAssumed, Vec::new()));
        }
        notes
    }

    /// The unit of length by the body height, unless a person says another.
    pub fn unit(&self, body: &Body, decisions: &Decisions) -> Option<(Unit, Source)> {
        let found = || {
            body.is_human()
                .then(|| world::unit(self.frame.height))
                .flatten()
        };
        let user = decisions.unit.map(|unit| (unit, Source::User));
        user.or_else(|| found().map(|unit| (unit, Source::Found)))
    }
}

/// The ground of the motion; of a clip without one, that of its skeleton.
fn ground_height(clip: &Clip, performer: usize, body: &Body, table: &PoseTable, up: Up) -> f64 {
    if clip.frames > 0 {
        return world::ground_height(table, up);
    }
    let skeleton = TableBuilder::new(clip, performer, body).rest();
    world::ground_height(&skeleton, up)
}

fn leading_rest(
    body: &Body,
    table: &PoseTable,
    frame: &PelvisFrame,
    decisions: &Decisions,
) -> LeadingRest {
    if let Some(frames) = decisions.leading_rest_frames {
        let frames = frames.min(table.frames());
        return LeadingRest {
            frames,
            reason: Some(RestReason::ByHand),
        };
    }
    let start = table.first_track(frame, rest::FRAMES_LOOKED_AT);
    let is_human = body.is_human() && !frame.is_root;
    rest::leading_rest_frames(&start, table.frames(), is_human)
}

fn up(table: &PoseTable, decisions: &Decisions) -> (Up, Source) {
    match (decisions.up, world::up_axis(table)) {
        (Some(up), _) => (up, Source::User),
        (None, Some(up)) => (up, Source::Found),
        (None, None) => (Up::PLUS_Y, Source::Default),
    }
}
