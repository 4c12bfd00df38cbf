//! What the tests of several crates share: the same random numbers everywhere, the folder of test
//! data, and lists out of JSON.

mod data;
mod json;
mod random;

pub use data::data_folder;
pub use json::{indices, numbers};
pub use random::Random;
