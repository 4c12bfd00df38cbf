//! Positions relative to the OFFSET: frames go in; the joints of which all positions are tiny
//! against their OFFSET come out.

use crate::skeleton::{Channel, Skeleton};

/// The part of the OFFSET's length below which all positions of a relative joint stay.
const TINY: f64 = 0.01;

/// A joint of one of the performers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct JointOf {
    /// The performer, from 0.
    pub performer: usize,
    /// The joint of its skeleton, from 0.
    pub joint: usize,
}

/// The joints that may still be relative.
#[derive(Debug, Default)]
pub struct Relative {
    candidates: Vec<Candidate>,
    frames: usize,
}

#[derive(Debug)]
struct Candidate {
    joint: JointOf,
    columns: Vec<usize>,
    limit: f64,
}

impl Relative {
    /// All joints but the roots that have position channels.
    pub fn new(skeletons: &[Skeleton]) -> Self {
        let mut candidates = Vec::new();
        let mut first_column = 0;
        for (performer, skeleton) in skeletons.iter().enumerate() {
            for (joint, own) in skeleton.joints.iter().enumerate().skip(1) {
                let columns = own.channels.iter().enumerate();
                let columns: Vec<_> = columns
                    .filter(|(_, channel)| matches!(channel, Channel::Position(_)))
                    .map(|(index, _)| first_column + own.first_channel + index)
                    .collect();
                let limit = TINY * own.offset.norm();
                if !columns.is_empty() && limit > 0.0 {
                    let joint = JointOf { performer, joint };
                    candidates.push(Candidate {
                        joint,
                        columns,
                        limit,
                    });
                }
            }
            first_column += skeleton.channel_count();
        }
        Self {
            candidates,
            frames: 0,
        }
    }

    /// Looks at the frames that are new among `frames` frames of `width` values.
    pub fn look(&mut self, values: &[f64], frames: usize, width: usize) {
        let new = values.get(self.frames * width..frames * width);
        self.frames = frames;
        let Some(new) = new.filter(|_| !self.candidates.is_empty()) else {
            return;
        };
        self.candidates.retain(|candidate| {
            new.chunks_exact(width).all(|frame| {
                let mut columns = candidate.columns.iter();
                columns.all(|column| frame[*column].abs() < candidate.limit)
            })
        });
    }

    /// The joints of which all positions were tiny.
    pub fn joints(self) -> Vec<JointOf> {
        match self.frames {
            0 => Vec::new(),
            _ => self
                .candidates
                .into_iter()
                .map(|candidate| candidate.joint)
                .collect(),
        }
    }
}
