//! Lists out of JSON.

use serde_json::Value;

/// A list of numbers.
pub fn numbers(value: &Value) -> Vec<f64> {
    let list = value.as_array().expect("a list");
    list.iter()
        .map(|number| number.as_f64().expect("a number"))
        .collect()
}

/// A list of whole numbers.
pub fn indices(value: &Value) -> Vec<usize> {
    let list = value.as_array().expect("a list");
    let as_index = |number: &Value| number.as_u64().expect("a whole number") as usize;
    list.iter().map(as_index).collect()
}
