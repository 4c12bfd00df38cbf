//! The matrix of all distances: a comparison goes in, a table of clips × clips comes out.

use result_text::csv::field;
use result_text::json::number;

use super::{Subject, npy};

/// A line of names, then one row for each clip with its distances to all.
pub fn matrix_csv(subject: &Subject) -> String {
    let names: Vec<String> = subject.names.iter().map(|name| field(name)).collect();
    let mut text = format!("clip,{}\r\n", names.join(","));
    for (item, name) in names.iter().enumerate() {
        text.push_str(name);
        for value in subject.comparison.distances.row(item) {
            text.push(',');
            text.push_str(&number(value));
        }
        text.push_str("\r\n");
    }
    text
}

/// Clips × clips.
pub fn matrix_npy(subject: &Subject) -> Vec<u8> {
    let distances = &subject.comparison.distances;
    let items = distances.items();
    let values = (0..items).flat_map(|item| distances.row(item));
    npy::table(items, items, values)
}
