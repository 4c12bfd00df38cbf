//! Work and a number of runs go in; the milliseconds of every run come out.

use std::hint::black_box;
use std::time::Instant;

/// Short work is repeated within a run until the run takes this long.
const SHORTEST_RUN_MS: f64 = 20.0;

/// Milliseconds of one call in each run, after a call to warm up.
pub fn timed<T>(runs: usize, work: impl Fn() -> T) -> Vec<f64> {
    let repeats = (SHORTEST_RUN_MS / call_ms(1, &work).max(0.01)).ceil() as usize;
    (0..runs).map(|_| call_ms(repeats, &work)).collect()
}

/// What work gives, and the milliseconds that it took, once.
pub fn once<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let start = Instant::now();
    let given = black_box(work());
    (given, start.elapsed().as_secs_f64() * 1e3)
}

fn call_ms<T>(repeats: usize, work: &impl Fn() -> T) -> f64 {
    let start = Instant::now();
    for _ in 0..repeats {
        black_box(work());
    }
    start.elapsed().as_secs_f64() * 1e3 / repeats as f64
}
