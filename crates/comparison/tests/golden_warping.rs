//! Warping of real clips against an independent implementation.

#[path = "support/recordings.rs"]
mod recordings;
mod support;

use comparison::warping::Warping;
use recordings::recording;
use support::{data_folder, golden, is_close};

#[test]
fn distances_with_and_without_a_band_are_those_of_the_reference() {
    let (Some(golden), Some(folder)) = (golden(), data_folder()) else {
        return;
    };
    let postures = |name: &str| recording(&folder.join(format!("cmu/{name}.bvh"))).postures;
    for (field, band) in [("dtw", None), ("dtw_band_half_second", Some(60))] {
        for (pair, expected) in golden[field].as_object().expect("pairs") {
            let (a, b) = pair.split_once(' ').expect("two names");
            let warping = Warping::new(&postures(a), &postures(b), band).expect("a warping");
            let (found, expected) = (
                warping.finish().distance,
                expected.as_f64().expect("a number"),
            );
            assert!(
                is_close(found, expected, 1e-9),
                "{field} {pair}: {found} {expected}"
            );
        }
    }
}
