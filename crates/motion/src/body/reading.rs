//! The names of a skeleton go in; what each says of its joint comes out.

use super::names::{self, Part};
use super::role::Side;
use super::tokens::{self, Tokens};
use crate::skeleton::Skeleton;

/// A word that at least this share of the joints begins with is a prefix of the rig.
const SHARED_PREFIX: f64 = 0.4;

/// What a name says.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Reading {
    /// The side it names.
    pub side: Option<Side>,
    /// The known word in it; empty where there is none.
    pub word: String,
    /// The numbers in it.
    pub numbers: Vec<u32>,
    /// The whole name without its side and the rig's prefix, to find its mirror image.
    pub stem: String,
    /// Whether it names the end of a chain.
    pub is_tip: bool,
    /// Whether it names a joint that carries no part of the body.
    pub is_helper: bool,
    /// Whether no human body has such a part.
    pub is_animal: bool,
}

impl Reading {
    /// How strongly the name means `part`, from 0 to 3.
    pub fn strength(&self, part: Part) -> u8 {
        names::strength(&self.word, part)
    }

    /// Whether the name can be a joint of a limb: neither a helper nor a tip.
    pub fn is_inner(&self) -> bool {
        !self.is_helper && !self.is_tip
    }
}

/// Reads the names of all joints; End Sites say nothing.
pub fn read(skeleton: &Skeleton) -> Vec<Reading> {
    let joints = &skeleton.joints;
    let mut all: Vec<Tokens> = joints
        .iter()
        .map(|joint| match joint.is_end_site {
            true => Tokens::default(),
            false => tokens::split(&joint.name),
        })
        .collect();
    while strip_shared_prefix(&mut all) {}
    let pairs = all.into_iter().zip(joints);
    pairs
        .map(|(tokens, joint)| read_one(tokens, &joint.name))
        .collect()
}

/// Takes a word off that many names begin with, unless it is a side or means a part.
fn strip_shared_prefix(all: &mut [Tokens]) -> bool {
    let Some(prefix) = shared_prefix(all) else {
        return false;
    };
    for tokens in all {
        if tokens.words.first().is_some_and(|word| word.text == prefix) {
            tokens.drop_first();
        }
    }
    true
}

fn shared_prefix(all: &[Tokens]) -> Option<String> {
    let firsts = || all.iter().filter_map(|tokens| tokens.words.first());
    let mut counts = std::collections::BTreeMap::new();
    for word in firsts() {
        *counts.entry(word.text.as_str()).or_insert(0_usize) += 1;
    }
    let enough = SHARED_PREFIX * firsts().count() as f64;
    let is_free = |word: &str| {
        !names::LEFT.contains(&word) && !names::RIGHT.contains(&word) && !names::is_known(word)
    };
    let found = counts
        .into_iter()
        .find(|(word, count)| *count > 2 && *count as f64 >= enough && is_free(word));
    found.map(|(word, _)| word.to_owned())
}

fn read_one(tokens: Tokens, name: &str) -> Reading {
    let mut words = tokens.words;
    let side = tokens::take_side(&mut words);
    let mut texts: Vec<String> = words.into_iter().map(|word| word.text).collect();
    let numbers: Vec<u32> = tokens
        .numbers
        .into_iter()
        .map(|(_, number)| number)
        .collect();
    let stem = format!("{}{numbers:?}", texts.concat());
    let is_tip = texts
        .iter()
        .any(|text| names::TIPS.contains(&text.as_str()));
    texts.retain(|text| !names::TIPS.contains(&text.as_str()));
    let word = known_word(&texts);
    let has = |list: &[&str]| texts.iter().any(|text| list.contains(&text.as_str()));
    Reading {
        is_helper: name.starts_with("__")
            || has(names::HELPERS)
            || (side.is_some() && has(names::SIDED_HELPERS))
            || (word.is_empty() && texts.iter().any(|text| text.contains(['捩', '親']))),
        is_animal: has(names::ANIMAL) && !has(names::COSTUME),
        side,
        word,
        numbers,
        stem,
        is_tip,
    }
}

/// The longest run of tokens that makes a known word; of equals the last, for the last word of an
/// English name says what it is (`lTorso_Clavicle`).
fn known_word(texts: &[String]) -> String {
    for length in (1..=texts.len()).rev() {
        for run in texts.windows(length).rev() {
            let word = run.concat();
            if names::is_known(&word) {
                return word;
            }
        }
    }
    String::new()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn one(name: &str) -> Reading {
        read_one(tokens::split(name), name)
    }

    #[test]
    fn the_known_word_is_found_among_others() {
        assert_eq!(one("lTorso_Clavicle").word, "clavicle");
        assert_eq!(one("torso_head").word, "head");
        assert_eq!(one("lShldrBend").word, "shldrbend");
        assert_eq!(one("LeftInHandMiddle").word, "handmiddle");
        assert_eq!(one("CC_Base_L_Upperarm").word, "upperarm");
        assert_eq!(one("L_foot_jnt").word, "foot");
    }

    #[test]
    fn tips_and_helpers_are_told() {
        assert!(one("HeadTop_End").is_tip);
        assert!(!one("lThighBend").is_tip);
        assert!(one("lThighTwist").is_helper && one("__UpLeg_L").is_helper);
        assert!(one("左足ＩＫ").is_helper && one("左腕捩").is_helper);
        assert!(!one("NeckTwist01").is_helper && !one("左親指１").is_helper);
    }

    #[test]
    fn a_tail_is_no_pony_tail() {
        assert!(one("BN_Tail_01").is_animal);
        assert!(!one("Hair_Tail_01").is_animal && !one("Detail").is_animal);
    }
}
