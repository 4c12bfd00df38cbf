//! Where the body is: the poses of one performer go in; its pelvis frame and the frames to leave
//! out come out.

use super::settings::{Decisions, Source};
use crate::body::{Body, PelvisFrame, PoseTable};
use crate::clip::Clip;
use crate::note::Note;
use crate::rest::{self, LeadingRest, RestReason};
use crate::world::{self, Unit};

/// What the coordinates of one performer are taken in.
#[derive(Clone, Debug, PartialEq)]
pub struct Placement {
    pub frame: PelvisFrame,
    pub leading_rest: LeadingRest,
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
        Self {
            leading_rest,
            frame: found,
        }
    }

    /// What was assumed.
    pub fn notes(&self) -> Vec<Note> {
        let mut notes = self.frame.notes.clone();
        notes.extend(self.leading_rest.note());
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
