//! The words of poses that are put together by hand.

#[test]
fn placeholder() {}
