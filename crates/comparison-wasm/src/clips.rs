//! The clips of a set, in the order of their numbers: numbers of JavaScript go in, features come out.

use std::rc::Rc;

use comparison::feature::{ClipFeature, FEATURE_LENGTH, JOINTS, Vector};

/// One clip that can be compared.
#[derive(Clone)]
pub struct NamedClip {
    /// Its number in the app.
    pub id: i32,
    /// What exports call it.
    pub name: String,
    /// What is compared of it.
    pub feature: Rc<ClipFeature>,
}

/// A feature from its four arrays.
///
/// # Errors
/// A sentence, where one has another length.
pub fn feature(
    recorded: &[f64],
    across_rigs: &[f64],
    recorded_by_joint: &[f64],
    across_rigs_by_joint: &[f64],
) -> Result<ClipFeature, String> {
    Ok(ClipFeature {
        recorded: vector(recorded)?,
        across_rigs: vector(across_rigs)?,
        recorded_by_joint: vectors(recorded_by_joint)?,
        across_rigs_by_joint: vectors(across_rigs_by_joint)?,
    })
}

fn vector(numbers: &[f64]) -> Result<Vector, String> {
    let length = numbers.len();
    let vector = numbers.try_into();
    vector.map_err(|_| format!("setFeature: {length} numbers, not {FEATURE_LENGTH}"))
}

fn vectors(numbers: &[f64]) -> Result<[Vector; JOINTS], String> {
    if numbers.len() != FEATURE_LENGTH * JOINTS {
        let (found, joints) = (numbers.len(), JOINTS);
        return Err(format!(
            "setFeature: {found} numbers, not {joints} times {FEATURE_LENGTH}"
        ));
    }
    let number = |joint: usize, index: usize| numbers[joint * FEATURE_LENGTH + index];
    Ok(std::array::from_fn(|joint| {
        std::array::from_fn(|index| number(joint, index))
    }))
}
