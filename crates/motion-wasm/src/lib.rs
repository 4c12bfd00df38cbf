//! The motion crate for WebAssembly: handles and exported functions that convert, call their twin
//! in the core and copy out.
//!
//! Bytes and settings go in; flat arrays, owned by JavaScript, and short summaries come out. A clip
//! lives in one [`ClipHandle`] with one owner, who frees it once. What fails for a reason of its own
//! is thrown as an `Error` whose message is the failure in JSON: kind, line, column, details.

mod clip_handle;
mod digest;
mod failure;
mod poses;
mod samples;
mod series;
mod settings;
mod summary;

pub use clip_handle::ClipHandle;
pub use digest::Digest;
pub use samples::{sample_bvh, sample_catalogue};
