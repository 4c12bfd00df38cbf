//! How well a set's labels are told apart: a set with labels goes in; JSON, or a table with a row for
//! each clip, come out.

use result_text::csv::field;
use result_text::json::{Json, number};

use super::provenance::{VERSION, parameters, parameters_text};
use super::{Labels, Subject};
use crate::evaluation::{self, OneNearest};

pub(super) const HEADER: &str =
    "clip,label,cluster,nearest,nearest_label,distance,is_right,version,parameters\r\n";

/// The scores with what they are of: one object on a line of its own.
pub(super) fn evaluation_json(subject: &Subject, nearest: &OneNearest) -> String {
    let labels = subject.labels.cloned().unwrap_or_default();
    let object = Json::object([
        ("version", VERSION.into()),
        ("parameters", parameters(subject)),
        (
            "clips",
            Json::list(subject.names.iter().map(String::as_str)),
        ),
        ("labels", label_list(subject, &labels)),
        (
            "clusters",
            Json::list(subject.cut.cluster_of_item.iter().copied()),
        ),
        ("evaluation", scores(subject, &labels, nearest)),
    ]);
    object.text() + "\n"
}

/// The label of each clip.
pub fn label_list(subject: &Subject, labels: &Labels) -> Json {
    Json::list((0..subject.names.len()).map(|item| Json::from(labels.of(item))))
}

/// The most labels whose confusion is written as a table: of n labels that is n² numbers.
const MOST_IN_A_TABLE: usize = 256;

/// `evaluation`: the clips held against their nearest ones, the cut against the labels. A score is
/// `null` where no clip has a label.
pub fn scores(subject: &Subject, labels: &Labels, nearest: &OneNearest) -> Json {
    let clustering = evaluation::clustering(&subject.cut.cluster_of_item, &labels.of_item);
    let score = |value: f64| Json::from((nearest.labelled > 0).then_some(value));
    let name = |item: usize| subject.names[item].as_str();
    let error = |(clip, near): &(usize, usize)| {
        Json::object([
            ("clip", name(*clip).into()),
            ("nearest", name(*near).into()),
        ])
    };
    Json::object([
        ("accuracy", score(nearest.accuracy)),
        ("best_reachable", score(nearest.best_reachable)),
        ("labelled", nearest.labelled.into()),
        ("correct", nearest.correct.into()),
        ("recall", score(clustering.recall)),
        ("precision", score(clustering.precision)),
        ("f", score(clustering.f)),
        (
            "labels",
            Json::list(labels.names.iter().map(String::as_str)),
        ),
        ("confusion", confusion(nearest, labels.names.len())),
        ("confusion_cells", confusion_cells(nearest)),
        ("errors", Json::list(nearest.errors.iter().map(error))),
        (
            "single",
            Json::list(
                nearest
                    .single
                    .iter()
                    .map(|label| labels.names[*label].as_str()),
            ),
        ),
    ])
}

/// Labels × labels: own label, label of the nearest; `null` of too many labels for a table.
fn confusion(nearest: &OneNearest, labels: usize) -> Json {
    if labels > MOST_IN_A_TABLE {
        return Json::Null;
    }
    let mut table = vec![vec![0; labels]; labels];
    for field in &nearest.confusion {
        table[field.own][field.nearest] = field.count;
    }
    Json::list(table.into_iter().map(Json::list))
}

/// Own label, label of the nearest and their number, of each field that is not 0.
fn confusion_cells(nearest: &OneNearest) -> Json {
    let cells = nearest.confusion.iter();
    Json::list(cells.map(|cell| Json::list([cell.own, cell.nearest, cell.count])))
}

/// One row for each clip: its label, its cluster, and the clip nearest to it; of a clip with a label the
/// nearest one with a label.
pub fn evaluation_csv(subject: &Subject) -> String {
    let labels = subject.labels.map(|labels| labels.of_item.as_slice());
    let nearest = subject.comparison.one_nearest(labels.unwrap_or(&[]));
    let mut text = HEADER.to_owned();
    for item in 0..subject.names.len() {
        push_row(&mut text, subject, Some(&nearest), item);
    }
    text
}

/// Adds the row of a clip.
pub(super) fn push_row(
    text: &mut String,
    subject: &Subject,
    among_labelled: Option<&OneNearest>,
    item: usize,
) {
    let own = subject.label_of(item);
    let nearest = match (own, among_labelled) {
        (Some(_), Some(among_labelled)) => among_labelled.nearest[item],
        _ => subject.comparison.spread.nearest[item],
    };
    let start = [&subject.names[item], own.unwrap_or_default()];
    let start = start.map(field).join(",");
    let cluster = subject.cut.cluster_of_item[item];
    let near = near(subject, item, nearest);
    let parameters = parameters_text(subject);
    text.push_str(&format!(
        "{start},{cluster},{near},{VERSION},{parameters}\r\n"
    ));
}

/// Name, label and distance of the nearest, and whether the label is right.
fn near(subject: &Subject, item: usize, nearest: Option<usize>) -> String {
    let Some(nearest) = nearest else {
        return ",,,".to_owned();
    };
    let (own, other) = (subject.label_of(item), subject.label_of(nearest));
    let texts = [subject.names[nearest].as_str(), other.unwrap_or_default()];
    let distance = number(subject.comparison.distances.at(item, nearest));
    let is_right = own.map_or_else(String::new, |_| (own == other).to_string());
    format!("{},{distance},{is_right}", texts.map(field).join(","))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluation::leave_one_out;

    /// Pairs of clips, of which the first ones alone have the same label.
    fn pairs(pairs: usize) -> OneNearest {
        let labels: Vec<_> = (0..2 * pairs).map(|item| Some(item.max(1) - 1)).collect();
        let distance = |one: usize, other: usize| (one / 2).abs_diff(other / 2) as f64;
        leave_one_out(&labels, distance)
    }

    #[test]
    fn a_confusion_is_a_table_and_its_cells() {
        let nearest = pairs(2);
        let table = "[[2,0,0],[0,0,1],[0,1,0]]";
        assert_eq!(confusion(&nearest, 3).text(), table);
        let cells = "[[0,0,2],[1,2,1],[2,1,1]]";
        assert_eq!(confusion_cells(&nearest).text(), cells);
    }

    #[test]
    fn of_many_labels_there_are_only_the_cells() {
        let nearest = pairs(1500);
        assert_eq!(confusion(&nearest, 2999), Json::Null);
        let Json::List(cells) = confusion_cells(&nearest) else {
            panic!("a list");
        };
        assert_eq!(cells.len(), 2999);
    }
}
