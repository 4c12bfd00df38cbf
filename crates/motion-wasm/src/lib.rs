//! The motion crate for WebAssembly.
