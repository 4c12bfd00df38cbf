//! Failures at the border: a typed error of the core goes in, a JavaScript `Error` comes out.

use motion::analysis::SettingsError;
use motion::bvh::ParseError;
use motion::note::Note;
use motion::report::json::Json;
use wasm_bindgen::JsError;

/// A failure as JSON, the shape of `Failure` in TypeScript.
pub fn json(kind: &str, place: (Option<usize>, Option<usize>), details: &[String]) -> Json {
    Json::object([
        ("kind", kind.into()),
        ("line", place.0.into()),
        ("column", place.1.into()),
        ("details", Json::list(details.iter().map(String::as_str))),
    ])
}

/// A note that says why there is no result, as JSON.
pub fn of_note(note: &Note) -> Json {
    json(note.kind.name(), (note.line, note.column), &note.details)
}

/// A file that cannot be read.
pub fn unreadable(error: &ParseError) -> JsError {
    let place = (Some(error.line), Some(error.column));
    JsError::new(&json(error.kind.name(), place, &error.details).text())
}

/// A setting that cannot be.
pub fn refused(error: &SettingsError) -> JsError {
    let details = [
        error.field.to_owned(),
        error.found.clone(),
        error.expected.to_owned(),
    ];
    JsError::new(&json("setting", (None, None), &details).text())
}

/// A call that the engine should not have made: a fault of the program, told in words.
pub fn misuse(message: &str) -> JsError {
    JsError::new(message)
}
