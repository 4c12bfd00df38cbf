//! One performer's poses, from the clip to its track, a part at a step: which joint is which, where
//! the body is and how it stands, and its principal joints frame by frame.

use super::following::{Followed, Following};
use super::placement::Placement;
use super::settings::Decisions;
use super::surroundings::Surroundings;
use crate::body::{self, Body, Footing, PelvisFrame, PoseTable, TableBuilder};
use crate::clip::Clip;

/// Joints placed in one step.
const JOINTS_A_STEP: usize = 1 << 15;

/// Frames turned into pelvis coordinates in one step.
const FRAMES_A_STEP: usize = 1 << 12;

/// The part done when all poses are in the table.
const POSED: f64 = 0.85;

/// The pieces, in the order in which they are made.
#[derive(Clone, Debug, Default)]
pub struct PoseRun {
    body: Option<Body>,
    /// Its joints become the track, in the same memory.
    table: PoseTable,
    /// The frame, once it is known to be that of the root though the body is human.
    root_frame: Option<PelvisFrame>,
    placement: Option<Placement>,
    following: Option<Following>,
    footing: Footing,
    followed: Option<Followed>,
    surroundings: Option<Surroundings>,
}

/// The finished pieces.
#[derive(Clone, Copy, Debug)]
pub struct Posed<'a> {
    pub body: &'a Body,
    pub placement: &'a Placement,
    pub followed: &'a Followed,
    pub surroundings: &'a Surroundings,
}

impl PoseRun {
    /// Takes away what other decisions make invalid. Returns whether the track is among it.
    pub fn change(&mut self, before: &Decisions, after: &Decisions) -> bool {
        if before.up != after.up || before.ground_height != after.ground_height {
            self.surroundings = None;
        }
        let is_same_track = before.leading_rest_frames == after.leading_rest_frames;
        if !is_same_track {
            self.drop_motion();
            self.root_frame = None;
            self.placement = None;
            self.surroundings = None;
        }
        !is_same_track
    }

    /// Frees the poses; they are made again when a later piece needs them.
    pub fn drop_motion(&mut self) {
        self.table = PoseTable::default();
        self.following = None;
        self.footing = Footing::default();
        self.followed = None;
    }

    /// Bytes that the poses take.
    pub fn motion_bytes(&self) -> usize {
        let following = self.following.as_ref().map_or(0, Following::capacity);
        let followed = self.followed.as_ref();
        let track = followed.map_or(0, |found| found.track.coordinates.capacity());
        let poses = track + following + self.table.joints.capacity() + self.table.hips.capacity();
        let feet = self.footing.feet.capacity() + self.table.footing.feet.capacity();
        poses * size_of::<f64>() + feet * size_of::<[f64; 6]>()
    }

    /// All pieces, once they are made.
    pub fn posed(&self) -> Option<Posed<'_>> {
        Some(Posed {
            body: self.body.as_ref()?,
            placement: self.placement.as_ref()?,
            followed: self.followed.as_ref()?,
            surroundings: self.surroundings.as_ref()?,
        })
    }

    /// Makes a part of the first missing piece. Returns the part done, below 1 until all are there.
    pub fn step(&mut self, clip: &Clip, performer: usize, decisions: &Decisions) -> f64 {
        let Some(body) = self.body.take() else {
            let joints = decisions.joints_of(performer);
            self.body = Some(body::find(clip, performer, &joints));
            return 0.0;
        };
        let done = match (&self.following, &self.followed, &self.placement) {
            (Some(_), ..) => self.follow(),
            (None, Some(_), Some(placement)) => {
                let (footing, frame) = (&self.footing, &placement.frame);
                let found = Surroundings::new(clip, performer, &body, footing, frame, decisions);
                self.surroundings = Some(found);
                1.0
            }
            _ => self.place(clip, performer, &body, decisions),
        };
        self.body = Some(body);
        done
    }

    /// Adds poses to the table, or, when all are there, makes what comes of it.
    fn place(&mut self, clip: &Clip, performer: usize, body: &Body, decisions: &Decisions) -> f64 {
        if self.table.frames() < clip.frames {
            self.add_poses(clip, performer, body);
        } else if let Some(placement) = &self.placement {
            let mut table = core::mem::take(&mut self.table);
            let first_frame = placement.leading_rest.frames;
            self.following = Some(Following::new(&mut table, &placement.frame, first_frame));
            self.footing = table.footing;
            return POSED;
        } else {
            self.place_body(clip, performer, body, decisions);
        }
        POSED * self.table.frames() as f64 / clip.frames.max(1) as f64
    }

    fn add_poses(&mut self, clip: &Clip, performer: usize, body: &Body) {
        let table = core::mem::take(&mut self.table);
        let placed = self.placement.as_ref().map(|placement| &placement.frame);
        let frame = self.root_frame.as_ref().or(placed);
        let mut builder = match frame.is_some_and(|frame| frame.is_root) {
            true => TableBuilder::in_root(clip, performer, body),
            false => TableBuilder::new(clip, performer, body),
        }
        .resume(table);
        let joints = clip.performers[performer].skeleton.joints.len();
        builder.step(JOINTS_A_STEP / joints.max(1) + 1);
        self.table = builder.finish();
    }

    fn place_body(&mut self, clip: &Clip, performer: usize, body: &Body, decisions: &Decisions) {
        let frame = self.root_frame.take();
        let is_in_root = frame.is_some() || body.pelvis == 0;
        let placement = Placement::new(clip, performer, body, &self.table, decisions, frame);
        if placement.frame.is_root && !is_in_root {
            // The coordinates are those of the root joint after all: once more from there.
            self.root_frame = Some(placement.frame);
            self.table = PoseTable::default();
        } else {
            self.placement = Some(placement);
        }
    }

    /// Follows the analysed frames; when all are done, keeps what was found in them.
    fn follow(&mut self) -> f64 {
        let Some(mut following) = self.following.take() else {
            return POSED;
        };
        let is_complete = following.advance(FRAMES_A_STEP);
        // Below 1: the surroundings are still to come.
        let done = POSED + 0.9 * (1.0 - POSED) * following.progress();
        if is_complete {
            self.followed = Some(following.finish());
        } else {
            self.following = Some(following);
        }
        done
    }
}
