//! What a pose looks like: where a human body's joints stand goes in, at most two words come out,
//! the most telling first.
//!
//! Every rule compares one measure of the pose with a threshold and says how far beyond it lies; the
//! farthest two are told, one of each part of the body. Up and down are the world's; before and
//! behind, left and right the body's.

mod arms;
mod legs;
mod pose;
mod trunk;
mod word;

pub use pose::Pose;
pub use word::{PosturePart, PostureState, PostureWord};

/// Most words that a pose is told in.
const MOST_WORDS: usize = 2;

/// A word, and how far beyond its threshold the pose is: 0 at it, about 1 in an extreme pose.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Candidate {
    word: PostureWord,
    score: f64,
}

/// The words of a pose, the most telling first.
pub fn posture(pose: &Pose) -> Vec<PostureWord> {
    let mut found = trunk::words(pose);
    let is_lying = found
        .iter()
        .any(|one| one.word.state == PostureState::Lying);
    if !is_lying {
        found.extend(legs::words(pose));
    }
    found.extend(arms::words(pose));
    // A stable sort: of equals the trunk, then the legs.
    found.sort_by(|a, b| b.score.total_cmp(&a.score));
    found.truncate(MOST_WORDS);
    match found.is_empty() && pose.is_upright() {
        true => vec![PostureWord::UPRIGHT],
        false => found.iter().map(|one| one.word).collect(),
    }
}

/// The word that fits a side best, if any does: states with their scores go in.
fn best<const N: usize>(states: [(PostureState, f64); N]) -> Option<(PostureState, f64)> {
    let fitting = states.into_iter().filter(|(_, score)| *score > 0.0);
    fitting.reduce(|best, one| if one.1 > best.1 { one } else { best })
}

/// The words of a pair of limbs: one for both where they do the same, else one for each.
fn paired(
    [left, right, both]: [PosturePart; 3],
    states: [Option<(PostureState, f64)>; 2],
) -> Vec<Candidate> {
    let word = |part, (state, score)| Candidate {
        word: PostureWord { part, state },
        score,
    };
    match states {
        [Some((state, one)), Some((same, other))] if state == same => {
            vec![word(both, (state, one.max(other)))]
        }
        [of_left, of_right] => {
            let of_left = of_left.map(|found| word(left, found));
            of_left
                .into_iter()
                .chain(of_right.map(|found| word(right, found)))
                .collect()
        }
    }
}

#[cfg(test)]
mod tests;
