//! Failures at the border: what went wrong goes in, a JavaScript `Error` comes out.

use result_text::json::Json;
use wasm_bindgen::JsError;

/// A setting that cannot be, as the shape of `Failure` in TypeScript.
pub fn refused(field: &str, found: &str, expected: &str) -> JsError {
    let failure = Json::object([
        ("kind", "setting".into()),
        ("line", Json::Null),
        ("column", Json::Null),
        ("details", Json::list([field, found, expected])),
    ]);
    JsError::new(&failure.text())
}

/// A call that the engine should not have made: a fault of the program, told in words.
pub fn misuse(message: &str) -> JsError {
    JsError::new(message)
}
