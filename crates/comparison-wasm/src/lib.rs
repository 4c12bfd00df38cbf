//! The comparison crate for WebAssembly: handles that convert, call their twin in the core and copy
//! out.
//!
//! Features and settings go in; flat arrays, owned by JavaScript, and short texts come out. A set lives
//! in one [`ComparisonHandle`] with one owner, who frees it once. A setting that cannot be is thrown as
//! an `Error` whose message is the failure in JSON.

mod clips;
mod comparison_handle;
mod exports;
mod failure;
mod places;
mod settings;
mod texts;
mod warp_handle;

pub use comparison_handle::ComparisonHandle;
pub use warp_handle::WarpHandle;
