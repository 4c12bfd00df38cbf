//! Reading BVH: the bytes of a file go in, in slices of any size; a clip with notes, or one error
//! with line and column, comes out.
//!
//! ```text
//! bytes ─▶ encoding (UTF-16 to UTF-8, byte order marks) ─▶ lines ─▶ hierarchy ─▶ header ─▶ rows ─▶ Clip
//! ```
//!
//! BVH has no standard. What is read how is written down in `docs/bvh.md`.

mod encoding;
mod error;
mod frame_time;
mod head;
mod header;
mod hierarchy;
mod lines;
mod notes;
mod number;
mod place;
mod reader;
mod rows;

pub use error::{ErrorKind, ParseError};
pub use reader::Reader;

use crate::clip::Clip;

/// What a file may hold at most; more is an error that names the limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Joints and End Sites of all performers.
    pub joints: usize,
    /// Bytes of the hierarchy without the indents of its lines.
    pub hierarchy_bytes: usize,
    /// Values of all rows (8 bytes each).
    pub values: usize,
}

impl Limits {
    /// 10 000 joints, 16 MB of hierarchy, 2²⁷ values (1 GiB).
    pub const DEFAULT: Self = Self {
        joints: 10_000,
        hierarchy_bytes: 16 << 20,
        values: 1 << 27,
    };
}

impl Default for Limits {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// Reads a whole file.
///
/// # Errors
/// Where the bytes cannot be read as BVH: the first thing found wrong, with its place.
pub fn parse(bytes: &[u8]) -> Result<Clip, ParseError> {
    let mut reader = Reader::new(Some(bytes.len() as u64));
    reader.push(bytes)?;
    reader.finish()
}
