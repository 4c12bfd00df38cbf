//! The `keypose` command: what is in motion capture files, and their keyposes.

mod arguments;
mod files;
mod in_order;
mod marks;

fn main() {}
