//! Failures at the border: what went wrong goes in, a JavaScript `Error` comes out.

use comparison::condensed::TooManyPairs;
use result_text::json::Json;
use wasm_bindgen::JsError;

/// A setting that cannot be.
pub fn refused(field: &str, found: &str, expected: &str) -> JsError {
    of_kind("setting", [field, found, expected])
}

/// Memory for all pairs is needed, and there is none.
pub fn too_many_pairs(pairs: &TooManyPairs) -> JsError {
    let megabytes = pairs.bytes.div_ceil(1_000_000).to_string();
    of_kind("too-many-pairs", [&pairs.items.to_string(), &megabytes])
}

/// What was asked is of a comparison that another one has followed.
pub fn compared_again() -> JsError {
    of_kind("compared-again", [])
}

/// A failure in the shape of `Failure` in TypeScript.
fn of_kind<const N: usize>(kind: &str, details: [&str; N]) -> JsError {
    let failure = Json::object([
        ("kind", kind.into()),
        ("line", Json::Null),
        ("column", Json::Null),
        ("details", Json::list(details)),
    ]);
    JsError::new(&failure.text())
}

/// A call that the engine should not have made: a fault of the program, told in words.
pub fn misuse(message: &str) -> JsError {
    JsError::new(message)
}
