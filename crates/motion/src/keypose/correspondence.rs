//! Which minimum of one time scale is which of the next: two ascending lists of frames in, a
//! partner for every member of the smaller out.
//!
//! The partners are the order-preserving one-to-one assignment of least total time difference;
//! among those of least cost the one in which every partner is the earliest, which is the same as
//! minimising (Σ |Δt|, Σ partner index) lexicographically.
//!
//! The method is regret matching with two heaps, O(n log n) time and O(n) memory. The two lists
//! are swept in time order. Each heap entry is a way to change what was decided so far, with its
//! cost, a pair (frames, index): one heap holds what a member of the smaller list would pay for a
//! place, the other what would be gained by moving an already placed member to a later place.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// (frames, partner index), compared lexicographically.
type Cost = (i64, i64);

/// Dearer than any path of changes, far from the ends of `i64`.
const NO_PLACE: Cost = (1 << 60, 0);

/// A possible change: its cost, and the place that changes between used and unused with it.
type Change = Reverse<(Cost, Option<usize>)>;

/// The partner in `larger` (an index) of each member of `smaller`, in order.
///
/// Both lists are frames in ascending order, without repeats, `smaller` not the longer one.
pub fn partners(smaller: &[usize], larger: &[usize]) -> Vec<usize> {
    if smaller.len() == larger.len() {
        return (0..larger.len()).collect();
    }
    let mut matching = Matching::new(larger.len());
    let mut next = 0;
    for &frame in smaller {
        while next < larger.len() && larger[next] <= frame {
            matching.place(next, larger[next]);
            next += 1;
        }
        matching.member(frame);
    }
    for (index, &frame) in larger.iter().enumerate().skip(next) {
        matching.place(index, frame);
    }
    let used = matching.used.iter().enumerate();
    used.filter_map(|(index, &used)| used.then_some(index))
        .collect()
}

struct Matching {
    used: Vec<bool>,
    /// What a member would pay for a place, its own time apart.
    places: BinaryHeap<Change>,
    /// What moving a placed member to a later place costs, that place's time apart.
    members: BinaryHeap<Change>,
}

impl Matching {
    fn new(places: usize) -> Self {
        Self {
            used: vec![false; places],
            places: BinaryHeap::new(),
            members: BinaryHeap::new(),
        }
    }

    /// Sweeps over a place: the larger list's entry `index` at `frame`.
    fn place(&mut self, index: usize, frame: usize) {
        let (time, index_cost) = (frame as i64, index as i64);
        if let Some(&Reverse((gain, changed))) = self.members.peek() {
            let difference = (gain.0 + time, gain.1 + index_cost);
            if difference < (0, 0) {
                self.members.pop();
                self.mark(Some(index), true);
                self.mark(changed, false);
                let back = (-difference.0 - time, -difference.1 + index_cost);
                self.places.push(Reverse((back, changed)));
                return;
            }
        }
        self.places
            .push(Reverse(((-time, index_cost), Some(index))));
    }

    /// Sweeps over a member of the smaller list at `frame`.
    fn member(&mut self, frame: usize) {
        let time = frame as i64;
        let Reverse((price, changed)) = self.places.pop().unwrap_or(Reverse((NO_PLACE, None)));
        self.mark(changed, true);
        let cost = (time + price.0, price.1);
        self.members
            .push(Reverse(((-cost.0 - time, -cost.1), changed)));
    }

    fn mark(&mut self, place: Option<usize>, used: bool) {
        if let Some(place) = place {
            self.used[place] = used;
        }
    }
}
