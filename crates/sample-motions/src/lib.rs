//! Synthetic dances and gaits as BVH, each with its true keyposes.
