//! What a body lacks to be human.

use super::reading::Reading;

/// Legs, arms and head as far as they were found, and words that no human body has.
pub fn missing(readings: &[Reading], legs: bool, arms: bool, head: bool) -> Vec<&'static str> {
    let is_animal = readings.iter().any(|reading| reading.is_animal);
    let parts = [
        (legs, "no two legs"),
        (arms, "no two arms"),
        (head, "no head"),
        (!is_animal, "parts of an animal"),
    ];
    parts
        .into_iter()
        .filter(|(there, _)| !there)
        .map(|(_, name)| name)
        .collect()
}
