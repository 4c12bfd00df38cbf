//! All that is known of a set, as one object: a set compared goes in, JSON comes out.

use result_text::json::Json;

use super::Subject;
use super::evaluation::{label_list, scores};
use super::provenance::{VERSION, parameters};
use crate::comparison::Neighbour;

/// Neighbours told of each clip.
const NEIGHBOURS: usize = 10;

/// A clip that is not compared.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOut {
    /// Its name.
    pub name: String,
    /// Why, as a word.
    pub reason: &'static str,
}

/// One object on a line of its own, as `docs/formats.md` describes it. `sha256` are those of the clips'
/// files.
pub fn set_json(subject: &Subject, sha256: &[String], left_out: &[LeftOut]) -> String {
    let comparison = subject.comparison;
    let vectors = comparison.vectors();
    let mut members = vec![
        ("version", VERSION.into()),
        ("parameters", parameters(subject)),
        ("clips", texts(subject.names)),
        ("sha256", texts(sha256)),
        (
            "labels",
            subject
                .labels
                .map(|labels| label_list(subject, labels))
                .into(),
        ),
        ("features", Json::list(vectors.into_iter().map(Json::list))),
        ("condensed", Json::list(comparison.distances.condensed())),
    ];
    members.extend(tree_members(subject));
    members.extend([
        (
            "map",
            Json::list(comparison.map.places.iter().copied().map(Json::list)),
        ),
        ("map_spread", comparison.map.spread.into()),
        ("neighbours", neighbours(subject)),
    ]);
    if let Some(labels) = subject.labels {
        let nearest = comparison.one_nearest(&labels.of_item);
        members.push(("evaluation", scores(subject, labels, &nearest)));
    }
    members.push(("left_out", Json::list(left_out.iter().map(left_out_object))));
    Json::Object(members).text() + "\n"
}

fn tree_members(subject: &Subject) -> Vec<(&'static str, Json)> {
    let (comparison, cut) = (subject.comparison, subject.cut);
    let merges = comparison.tree.merges.iter().map(|merge| {
        let (left, right, size) = (merge.left.into(), merge.right.into(), merge.size.into());
        Json::List(vec![left, right, merge.height.into(), size])
    });
    vec![
        ("merges", Json::list(merges)),
        (
            "leaves",
            Json::list(comparison.order.leaves.iter().copied()),
        ),
        ("order_is_optimal", comparison.order.optimal.into()),
        ("clusters", Json::list(cut.cluster_of_item.iter().copied())),
        ("cluster_count", cut.clusters.into()),
        ("cut_height", cut.height.into()),
        ("bic", Json::list(comparison.bic.iter().copied())),
    ]
}

fn neighbours(subject: &Subject) -> Json {
    let one = |found: Neighbour| {
        Json::object([
            ("clip", subject.names[found.item].as_str().into()),
            ("distance", found.distance.into()),
            ("mirrored", found.mirrored.into()),
        ])
    };
    let of = |item: usize| {
        let found = subject.comparison.neighbours(item, NEIGHBOURS);
        Json::list(found.into_iter().map(one))
    };
    Json::list((0..subject.names.len()).map(of))
}

fn left_out_object(one: &LeftOut) -> Json {
    Json::object([
        ("clip", one.name.as_str().into()),
        ("reason", one.reason.into()),
    ])
}

fn texts(all: &[String]) -> Json {
    Json::list(all.iter().map(String::as_str))
}
