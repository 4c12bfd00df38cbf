//! What is said of a pair and of an evaluation, as JSON: the shapes of `comparison-raw.ts`.

use comparison::comparison::{Evaluation, Neighbour};
use comparison::explanation::{Explanation, Half, Sentence, Which};
use comparison::ranks::Ranks;
use result_text::json::Json;

/// The explanation of a pair.
pub fn explanation(found: &Explanation, ranks: Ranks) -> Json {
    Json::object([
        ("distance", found.distance.value.into()),
        ("mirrored", found.distance.mirrored.into()),
        ("rank", ranks.of_all.into()),
        ("rankFromA", ranks.from_a.into()),
        ("rankFromB", ranks.from_b.into()),
        ("shares", Json::list(found.shares)),
        ("partShares", Json::list(found.part_shares)),
        ("jointShares", Json::list(found.joint_shares)),
        ("sentence", sentence(&found.sentence)),
    ])
}

fn sentence(sentence: &Sentence) -> Json {
    match sentence {
        Sentence::Same => Json::object([("kind", "same".into())]),
        Sentence::Everything { parts } => Json::object([
            ("kind", "everything".into()),
            ("parts", Json::list(parts.iter().copied())),
        ]),
        Sentence::Component {
            component,
            of,
            share,
            larger,
            parts,
        } => Json::object([
            ("kind", "component".into()),
            ("component", (*component).into()),
            ("of", half(*of).into()),
            ("share", (*share).into()),
            ("larger", which(*larger).into()),
            ("parts", Json::list(parts.iter().copied())),
        ]),
    }
}

fn half(half: Half) -> &'static str {
    match half {
        Half::Mean => "mean",
        Half::Deviation => "deviation",
    }
}

fn which(which: Which) -> &'static str {
    match which {
        Which::A => "a",
        Which::B => "b",
    }
}

/// The neighbours of a clip; `id` gives the number of an item in the app.
pub fn neighbours(found: &[Neighbour], id: impl Fn(usize) -> i32) -> Json {
    Json::list(found.iter().map(|one| {
        Json::object([
            ("clip", f64::from(id(one.item)).into()),
            ("distance", one.distance.into()),
            ("mirrored", one.mirrored.into()),
        ])
    }))
}

/// The scores of a cut; `id` gives the number of an item in the app.
pub fn evaluation(found: &Evaluation, id: impl Fn(usize) -> i32) -> Json {
    let nearest = &found.one_nearest;
    let error = |(clip, near): &(usize, usize)| {
        Json::object([
            ("clip", f64::from(id(*clip)).into()),
            ("nearest", f64::from(id(*near)).into()),
        ])
    };
    let field = |field: &comparison::evaluation::Confusion| {
        Json::list([field.own, field.nearest, field.count])
    };
    Json::object([
        ("labelled", nearest.labelled.into()),
        ("correct", nearest.correct.into()),
        ("accuracy", nearest.accuracy.into()),
        ("bestReachable", nearest.best_reachable.into()),
        (
            "confusion",
            Json::List(nearest.confusion.iter().map(field).collect()),
        ),
        (
            "errors",
            Json::List(nearest.errors.iter().map(error).collect()),
        ),
        ("single", Json::list(nearest.single.iter().copied())),
        ("recall", found.scores.recall.into()),
        ("precision", found.scores.precision.into()),
        ("f", found.scores.f.into()),
    ])
}
