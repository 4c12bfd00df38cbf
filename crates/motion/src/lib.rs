//! Motion capture in BVH.
