//! The words of joint names, as data: what a word can mean, and how strongly.
//!
//! A joint's name comes here as one lower-case word without side, digits and separators
//! (`LeftUpLeg_01` is `upleg`). To teach the tool a new rig, add its words to the lines below: that is all.
//! A word may stand in several lines; the chain of joints then decides (`hand` is a wrist, unless a
//! `wrist` stands above it). Strength 3 is a word that means one thing in every convention known,
//! 2 a word that means another thing in some, 1 a word that means it only where nothing better is there.

/// What a word says about its joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Part {
    /// The middle of the hips.
    Pelvis,
    /// A joint of a side that stands before its hip.
    BeforeHip,
    /// The joint that starts the thigh.
    Hip,
    /// The joint that starts the shin.
    Knee,
    /// The joint that starts the foot.
    Ankle,
    /// Below the ankle, backwards.
    Heel,
    /// Below the ankle, forwards.
    Toe,
    /// The spine.
    Trunk,
    /// The neck.
    Neck,
    /// The head.
    Head,
    /// On the head, and no tip of it.
    Face,
    /// The joint before the upper arm.
    Clavicle,
    /// The joint that starts the upper arm.
    Shoulder,
    /// The joint that starts the forearm.
    Elbow,
    /// The joint that starts the hand.
    Wrist,
    /// The middle finger.
    MiddleFinger,
    /// Any other finger, or the hand's palm.
    Finger,
    /// The thumb.
    Thumb,
}

/// Part, strength, words.
#[rustfmt::skip]
pub const WORDS: &[(Part, u8, &[&str])] = &[
    (Part::Pelvis, 3, &["pelvis", "hips", "腰", "骨盤", "骨盆"]),
    (Part::Pelvis, 2, &["hip", "root", "下半身", "センター"]),
    (Part::BeforeHip, 3, &["hipjoint", "buttock", "glute", "pelvis", "waist", "足親", "腰"]),
    (Part::Hip, 3, &["upleg", "upperleg", "legupper", "upperlegbend", "thigh", "thighbend", "femur", "uleg", "太もも", "もも", "大腿"]),
    (Part::Hip, 2, &["hip", "hips", "足"]),
    (Part::Hip, 1, &["leg", "hipjoint"]),
    (Part::Knee, 3, &["knee", "shin", "shinbend", "calf", "lowleg", "lowerleg", "leglower", "loleg", "tibia", "ひざ", "膝", "すね", "下腿", "小腿"]),
    (Part::Knee, 2, &["leg"]),
    (Part::Knee, 1, &["thigh"]),
    (Part::Ankle, 3, &["ankle", "talus", "足首", "脚踝"]),
    (Part::Ankle, 2, &["foot", "feet", "脚"]),
    (Part::Ankle, 1, &["calf"]),
    (Part::Heel, 3, &["heel", "calcaneus", "かかと"]),
    (Part::Toe, 3, &["toe", "toes", "toebase", "bigtoe", "ball", "forefoot", "metatarsals", "metatarsal", "つま先", "足先", "つまさき", "脚趾"]),
    (Part::Toe, 2, &["foot", "feet", "smalltoe"]),
    (Part::Trunk, 3, &["spine", "chest", "abdomen", "ab", "torso", "back", "waist", "lowerback", "upperback", "thorax", "stomach", "belly", "rib", "ribs", "sternum", "lumbar", "thoracic", "vertebra", "trunk", "body", "上半身", "胸", "脊椎", "naval", "navel"]),
    (Part::Neck, 3, &["neck", "lowerneck", "upperneck", "neckupper", "necklower", "necktwist", "cervical", "首", "脖子", "颈"]),
    (Part::Neck, 1, &["shouldercenter", "centershoulder", "spineshoulder", "shoulderspine"]),
    (Part::Head, 3, &["head", "skull", "cranium", "頭", "頭部", "头"]),
    (Part::Face, 3, &["eye", "eyes", "jaw", "nose", "ear", "teeth", "tongue", "brow", "lip", "mouth", "chin", "eyelid", "cheek", "face", "hair", "hat", "cap", "目", "両目", "髪", "あご"]),
    (Part::Clavicle, 3, &["collar", "collarbone", "clavicle", "clav", "scapula", "shoulderblade", "鎖骨", "锁骨"]),
    (Part::Clavicle, 2, &["shoulder", "肩"]),
    (Part::Shoulder, 3, &["arm", "upperarm", "armupper", "uparm", "uarm", "upperarmbend", "shldr", "shldrbend", "humerus", "bicep", "腕", "上腕", "上臂"]),
    (Part::Shoulder, 2, &["shoulder"]),
    (Part::Shoulder, 1, &["肩"]),
    (Part::Elbow, 3, &["elbow", "forearm", "forearmbend", "lowerarm", "armlower", "lowarm", "loarm", "farm", "radius", "ulna", "ひじ", "肘", "前腕", "前臂"]),
    (Part::Elbow, 1, &["arm"]),
    (Part::Wrist, 3, &["wrist", "手首"]),
    (Part::Wrist, 2, &["hand", "手"]),
    (Part::Wrist, 1, &["forearm"]),
    (Part::MiddleFinger, 3, &["middle", "mid", "handmiddle", "middlefinger", "midfinger", "中指"]),
    (Part::Finger, 3, &["finger", "fingers", "fingerbase", "palm", "carpal", "metacarpal", "index", "ring", "pinky", "pinkie", "little", "handtip", "人指", "人差指", "薬指", "小指", "hand"]),
    (Part::Thumb, 3, &["thumb", "thumbfinger", "親指", "拇指"]),
];

/// Words for the very end of a chain; such a joint starts no limb.
pub const TIPS: &[&str] = &[
    "end", "tip", "nub", "top", "effector", "eff", "site", "endsite", "先",
];

/// Words of joints that carry no part of the body of their own.
pub const HELPERS: &[&str] = &[
    "virtual", "split", "prop", "ik", "rigmesh", "helper", "dummy", "pole", "target", "weapon",
    "muscle", "socket", "捩", "親",
];

/// Words of helpers where the joint has a side (`NeckTwist` is a neck).
pub const SIDED_HELPERS: &[&str] = &["twist", "roll"];

/// Words that no human body has.
pub const ANIMAL: &[&str] = &[
    "tail",
    "wing",
    "wings",
    "hoof",
    "horselink",
    "paw",
    "beak",
    "しっぽ",
    "尻尾",
    "翼",
];

/// Words that make a `tail` or a `wing` part of a costume.
pub const COSTUME: &[&str] = &[
    "hair",
    "pony",
    "coat",
    "skirt",
    "cloth",
    "cape",
    "dress",
    "髪",
    "スカート",
];

/// Tokens for the left side of the person.
pub const LEFT: &[&str] = &["left", "l", "左", "lft"];

/// Tokens for the right side of the person.
pub const RIGHT: &[&str] = &["right", "r", "右", "rgt"];

/// How strongly `word` means `part`: 3, 2, 1, or 0 if it does not.
pub fn strength(word: &str, part: Part) -> u8 {
    WORDS
        .iter()
        .filter(|(of, _, words)| *of == part && words.contains(&word))
        .map(|(_, strength, _)| *strength)
        .max()
        .unwrap_or(0)
}

/// Whether `word` stands in the table.
pub fn is_known(word: &str) -> bool {
    WORDS.iter().any(|(_, _, words)| words.contains(&word))
}

/// Whether `word` is a part that comes in pairs, so that a glued `l` or `r` is its side.
pub fn is_paired(word: &str) -> bool {
    const UNPAIRED: &[Part] = &[
        Part::Pelvis,
        Part::Trunk,
        Part::Neck,
        Part::Head,
        Part::Face,
    ];
    WORDS
        .iter()
        .any(|(part, _, words)| !UNPAIRED.contains(part) && words.contains(&word))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_lower_case_and_stand_once_in_a_part() {
        for (part, strength, words) in WORDS {
            assert!((1..=3).contains(strength));
            for word in *words {
                assert_eq!(&word.to_lowercase(), word);
                let lines = WORDS
                    .iter()
                    .filter(|(of, _, words)| of == part && words.contains(word));
                assert_eq!(lines.count(), 1, "{word} stands twice in {part:?}");
            }
        }
    }

    #[test]
    fn a_word_may_mean_several_parts() {
        assert_eq!(strength("shoulder", Part::Clavicle), 2);
        assert_eq!(strength("shoulder", Part::Shoulder), 2);
        assert_eq!(strength("shoulder", Part::Knee), 0);
    }
}
