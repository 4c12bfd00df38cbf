//! A tree in; how many clusters it is best cut into, out.

pub mod bic;
pub mod mojena;
