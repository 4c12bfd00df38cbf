//! Work on many items at once, results handed out in the order of the items.

use std::collections::BTreeMap;
use std::sync::mpsc;

use anyhow::Result;
use rayon::iter::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};

/// Runs `work` on every item with `threads` threads (0: one for each processor) and calls `emit`
/// for each result, in the order of the items, as soon as it and all before it are there.
///
/// # Errors
/// The threads cannot be started, or `emit` fails.
pub fn for_each<I: Sync, R: Send>(
    items: &[I],
    threads: usize,
    work: impl Fn(&I) -> R + Sync,
    mut emit: impl FnMut(R) -> Result<()>,
) -> Result<()> {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()?;
    let (sender, receiver) = mpsc::channel();
    std::thread::scope(|scope| {
        scope.spawn(|| {
            pool.install(|| {
                // A closed channel means that emitting failed: the rest is of no use.
                let send = |(index, item)| sender.send((index, work(item))).ok();
                items
                    .par_iter()
                    .with_max_len(1)
                    .enumerate()
                    .map(send)
                    .while_some()
                    .for_each(drop);
            });
            drop(sender);
        });
        let mut waiting = BTreeMap::new();
        let mut next = 0;
        for (index, result) in receiver {
            waiting.insert(index, result);
            while let Some(result) = waiting.remove(&next) {
                emit(result)?;
                next += 1;
            }
        }
        Ok(())
    })
}

#[cfg(test)]
mod tests {
    use super::for_each;

    #[test]
    fn results_come_in_the_order_of_the_items() {
        let items: Vec<u64> = (0..200).collect();
        let slow_first = |&item: &u64| {
            std::thread::sleep(std::time::Duration::from_micros(200 - item));
            item
        };
        let mut results = Vec::new();
        let keep = |item| {
            results.push(item);
            Ok(())
        };
        for_each(&items, 4, slow_first, keep).unwrap();
        assert_eq!(results, items);
    }

    #[test]
    fn a_failing_receiver_ends_the_work() {
        let items: Vec<u64> = (0..1000).collect();
        let result = for_each(&items, 2, |&item| item, |_| anyhow::bail!("full disk"));
        assert_eq!(result.unwrap_err().to_string(), "full disk");
    }
}
