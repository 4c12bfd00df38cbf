//! Recordings as the core reads them: their comparable features and their postures.

#![allow(dead_code, reason = "not every test file uses all of this module")]

use std::fs;
use std::path::Path;

use comparison::feature::ClipFeature;
use motion::analysis::{Analyser, Decisions};
use motion::keypose::Options;

/// What is compared of the first performer of a recording.
pub struct Recording {
    /// Its features.
    pub feature: ClipFeature,
    /// Frames × joints × (x, y, z) in pelvis coordinates.
    pub postures: Vec<f64>,
}

/// Reads a file.
pub fn recording(path: &Path) -> Recording {
    let bytes = fs::read(path).expect("a readable file");
    let clip = motion::bvh::parse(&bytes).expect("a motion");
    let mut analyser = Analyser::new();
    let begun = analyser.begin(&clip, &Decisions::default(), &Options::default());
    begun.expect("sound settings");
    while analyser.step_survey(&clip) < 1.0 {}
    let survey = analyser.survey();
    let found = survey.performers[0].comparable.clone();
    let found = found.expect("a human body");
    Recording {
        feature: ClipFeature {
            recorded: found.recorded,
            across_rigs: found.across_rigs,
            recorded_by_joint: found.recorded_by_joint,
            across_rigs_by_joint: found.across_rigs_by_joint,
        },
        postures: analyser.track(0).expect("a track").coordinates.clone(),
    }
}
