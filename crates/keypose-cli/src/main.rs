//! The keypose command.

fn main() {}
