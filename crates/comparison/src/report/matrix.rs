//! The matrix of all distances as a table: a comparison goes in, its head and its rows come out.

use result_text::csv::field;
use result_text::json::number;

use super::Subject;

/// The line of names.
pub(super) fn head(subject: &Subject) -> String {
    let names: Vec<String> = subject.names.iter().map(|name| field(name)).collect();
    format!("clip,{}\r\n", names.join(","))
}

/// Adds the row of a clip: its distances to all.
pub(super) fn push_row(text: &mut String, subject: &Subject, item: usize) {
    text.push_str(&field(&subject.names[item]));
    for value in subject.comparison.distances.row(item) {
        text.push(',');
        text.push_str(&number(value));
    }
    text.push_str("\r\n");
}
