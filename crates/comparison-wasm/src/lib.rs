//! The comparison crate for WebAssembly: handles that convert, call their twin in the core and copy
//! out.
//!
//! Features and settings go in; flat arrays, owned by JavaScript, and short texts come out. A set lives
//! in one [`ComparisonHandle`] with one owner, who frees it once. A setting that cannot be is thrown as
//! an `Error` whose message is the failure in JSON.

mod answers;
mod clips;
mod compared;
mod comparison_handle;
mod failure;
mod file_handle;
mod picture_handle;
mod places;
mod settings;
mod texts;
mod warp_handle;

pub use answers::{EvaluationHandle, ExplanationHandle};
pub use comparison_handle::ComparisonHandle;
pub use file_handle::FileHandle;
pub use picture_handle::PictureHandle;
pub use warp_handle::WarpHandle;
