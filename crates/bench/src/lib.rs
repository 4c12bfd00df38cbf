//! What the programs of the benchmark share: how time is taken, and vectors to cluster.

pub mod timing;
pub mod vectors;
