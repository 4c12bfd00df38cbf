//! The body while it is being found: joints come in role by role, a person's choices first.

use super::human;
use super::limbs::Limb;
use super::reading::Reading;
use super::role::{Role, Side};
use super::{Body, BodyJoint, Kind, Source};
use crate::note::{Note, NoteKind};
use crate::skeleton::Skeleton;

/// The joints found so far.
#[derive(Clone, Debug)]
pub struct Draft {
    joints: [Option<(usize, Source)>; Role::ALL.len()],
    /// The joint of the head, of which [`Role::Head`] is the tip, and why it was taken.
    pub head: Option<(usize, Source)>,
}

impl Draft {
    /// A person's choices, for a skeleton of `joints` joints.
    pub fn new(overrides: &[(Role, usize)], joints: usize) -> Self {
        let mut draft = Self {
            joints: [None; Role::ALL.len()],
            head: None,
        };
        for (role, joint) in overrides.iter().filter(|(_, joint)| *joint < joints) {
            draft.joints[role.index()] = Some((*joint, Source::User));
        }
        draft
    }

    /// The joint of a role, and why it was taken.
    pub fn found(&self, role: Role) -> Option<(usize, Source)> {
        self.joints[role.index()]
    }

    /// The joint of a role.
    pub fn joint(&self, role: Role) -> Option<usize> {
        self.found(role).map(|(joint, _)| joint)
    }

    /// Gives a role its joint, unless it has one.
    pub fn set(&mut self, role: Role, joint: usize, source: Source) {
        self.joints[role.index()].get_or_insert((joint, source));
    }

    /// Gives the roles of legs and arms their joints, unless they have one.
    pub fn set_limbs(&mut self, legs: Option<[Limb; 2]>, arms: Option<[Limb; 2]>, source: Source) {
        for side in Side::BOTH {
            for (limbs, roles) in [(legs, Role::leg(side)), (arms, Role::arm(side))] {
                let limb = limbs.map(|limbs| limbs[side.index()]);
                for (role, joint) in roles.into_iter().zip(limb.into_iter().flatten()) {
                    self.set(role, joint, source);
                }
            }
        }
    }

    /// Gives an end its joint: what `tip` finds from the joint that it ends.
    pub fn set_end(
        &mut self,
        role: Role,
        ended: Option<(usize, Source)>,
        tip: impl Fn(usize) -> usize,
    ) {
        if let Some((joint, source)) = ended {
            let end = tip(joint);
            let source = match source {
                _ if end == joint => Source::Fallback,
                Source::Shape => Source::Shape,
                _ => Source::Name,
            };
            self.set(role, end, source);
        }
    }

    /// Both legs, if they are whole.
    pub fn legs(&self) -> Option<[Limb; 2]> {
        self.limbs(Role::leg)
    }

    /// Both arms, if they are whole.
    pub fn arms(&self) -> Option<[Limb; 2]> {
        self.limbs(Role::arm)
    }

    fn limbs(&self, roles: impl Fn(Side) -> [Role; 4]) -> Option<[Limb; 2]> {
        let limb = |side: Side| -> Option<Limb> {
            let [start, middle, end, _] = roles(side);
            Some([self.joint(start)?, self.joint(middle)?, self.joint(end)?])
        };
        Some([limb(Side::Left)?, limb(Side::Right)?])
    }

    /// A note for each end that its parent stands for.
    pub fn fallback_notes(&self, skeleton: &Skeleton) -> Vec<Note> {
        let labels = skeleton.labels();
        let note = |role: &Role| match self.joints[role.index()] {
            Some((joint, Source::Fallback)) => {
                let details = vec![role.name().replace('_', " "), labels[joint].clone()];
                Some(Note::new(NoteKind::EndEffectorFallback, details))
            }
            _ => None,
        };
        Role::ALL.iter().filter_map(note).collect()
    }

    /// The body. A person's choice sets aside what the names say of animals.
    pub fn finish(self, readings: &[Reading], mut notes: Vec<Note>, by_hand: bool) -> Body {
        let head = self.joint(Role::Head).is_some();
        let readings = if by_hand { &[] } else { readings };
        let missing = human::missing(readings, self.legs().is_some(), self.arms().is_some(), head);
        let pairs = Role::ALL.iter().zip(self.joints);
        let joints = pairs.filter_map(|(role, found)| {
            let (joint, source) = found?;
            Some(BodyJoint {
                role: *role,
                joint,
                source,
            })
        });
        let mut body = Body {
            kind: Kind::Human,
            pelvis: self.joint(Role::Pelvis).unwrap_or(0),
            hips: [Role::LeftHip, Role::RightHip].map(|role| self.joint(role).unwrap_or(0)),
            joints: joints.collect(),
            notes: Vec::new(),
        };
        if !missing.is_empty() {
            notes = vec![Note::new(NoteKind::NotHuman, vec![missing.join(", ")])];
            body.kind = Kind::Other { missing };
            body.pelvis = 0;
            body.hips = [0, 0];
        }
        body.notes = notes;
        body
    }
}
