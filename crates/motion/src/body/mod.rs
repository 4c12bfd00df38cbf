//! The body: a skeleton goes in, and which of its joints are the principal ones comes out.
//!
//! Names first, looked up in the tables of [`names`]; the shape where they fail; a person's
//! corrections above both. The rules and how to add a rig: `docs/body.md`.

mod draft;
mod ends;
mod find;
mod human;
mod limbs;
mod mirrored;
pub mod names;
mod part;
mod pelvis_frame;
mod reading;
mod rest_pose;
mod role;
mod shape;
mod sides;
mod table;
mod tokens;
mod track_run;
mod tree;
mod trunk;

pub use find::find;
pub use part::{BODY_PARTS, BodyPart};
pub use pelvis_frame::PelvisFrame;
pub use role::{PRINCIPAL_JOINTS, Role, Side};
pub use table::{Footing, PoseTable, TableBuilder};
pub use track_run::TrackRun;

use crate::clip::Clip;
use crate::note::Note;
use crate::track::PelvisTrack;

/// Why a joint was taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// Its name.
    Name,
    /// The shape of the skeleton.
    Shape,
    /// A person chose it.
    User,
    /// An end that is missing: its parent stands for it.
    Fallback,
}

/// Which joint takes a role, and why.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BodyJoint {
    /// The place of the body.
    pub role: Role,
    /// The joint's index in the skeleton.
    pub joint: usize,
    /// Why it was taken.
    pub source: Source,
}

/// Whether the skeleton is a person.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Two legs, two arms and a head.
    Human,
    /// Anything else.
    Other {
        /// What it lacks, e.g. `no two arms`.
        missing: Vec<&'static str>,
    },
}

/// The body found in one performer's skeleton.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Whether it is a person.
    pub kind: Kind,
    /// The pelvis joint; the root where the body is not human.
    pub pelvis: usize,
    /// The left and the right hip; the root where the body is not human.
    pub hips: [usize; 2],
    /// The joints in the order of [`Role::ALL`]: the 16 principal ones, pelvis and hips in a human, as many
    /// of them as were found in any other body.
    pub joints: Vec<BodyJoint>,
    /// What was assumed.
    pub notes: Vec<Note>,
}

impl Body {
    /// Whether it is a person.
    pub fn is_human(&self) -> bool {
        self.kind == Kind::Human
    }

    /// The joint of a role, if it was found.
    pub fn joint(&self, role: Role) -> Option<usize> {
        let found = self.joints.iter().find(|joint| joint.role == role);
        found.map(|joint| joint.joint)
    }

    /// The joints that the analysis follows: the 16 principal ones, or all (End Sites left out)
    /// where the body is not human.
    pub fn analysed(&self, clip: &Clip, performer: usize) -> Vec<usize> {
        if self.is_human() {
            return self.joints[..PRINCIPAL_JOINTS]
                .iter()
                .map(|joint| joint.joint)
                .collect();
        }
        let joints = &clip.performers[performer].skeleton.joints;
        (0..joints.len())
            .filter(|joint| !joints[*joint].is_end_site)
            .collect()
    }
}

/// Follows one performer's body through the motion: its joints in pelvis coordinates from `first_frame` on.
pub fn track(
    clip: &Clip,
    performer: usize,
    body: &Body,
    frame: &PelvisFrame,
    first_frame: usize,
) -> PelvisTrack {
    let mut builder = TableBuilder::new(clip, performer, body);
    builder.step(clip.frames);
    builder.finish().into_track(frame, first_frame)
}
