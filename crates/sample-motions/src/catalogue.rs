//! The samples that an application offers.

use crate::rig::Rig;
use crate::sample::{Motion, Rate, Sample};

/// A sample with a name that stays the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Name for links and message catalogues, also the file's name without suffix.
    pub id: &'static str,
    /// What it is.
    pub sample: Sample,
}

const ENTRIES: [Entry; 4] = [
    Entry {
        id: "slow-dance",
        sample: Sample {
            motion: Motion::SlowDance,
            rig: Rig::Hik,
            rate: Rate::Hz60,
        },
    },
    Entry {
        id: "tired-dance",
        sample: Sample {
            motion: Motion::TiredDance,
            rig: Rig::Vrm,
            rate: Rate::Hz30,
        },
    },
    Entry {
        id: "walk",
        sample: Sample {
            motion: Motion::Walk,
            rig: Rig::Poser,
            rate: Rate::Hz120,
        },
    },
    Entry {
        id: "run",
        sample: Sample {
            motion: Motion::Run,
            rig: Rig::Hik,
            rate: Rate::Hz120,
        },
    },
];

/// The samples in the order in which they are offered.
pub fn catalogue() -> &'static [Entry] {
    &ENTRIES
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_motion_is_offered_once() {
        let motions: Vec<Motion> = catalogue()
            .iter()
            .map(|entry| entry.sample.motion)
            .collect();
        assert_eq!(motions, Motion::ALL);
        assert!(
            catalogue()
                .iter()
                .all(|entry| entry.id == entry.sample.motion.id())
        );
    }
}
