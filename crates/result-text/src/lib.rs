//! How results are written: values go in, text comes out, the same bytes from the command line and
//! the browser. What the results are is the matter of the crates that have them.

pub mod csv;
pub mod json;
