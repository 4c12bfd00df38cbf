//! Clusters and how far they are in; the nearest out.

/// The nearest cluster so far.
pub(in crate::linkage) struct Best {
    pub(in crate::linkage) slot: Option<usize>,
    pub(in crate::linkage) distance: f64,
    /// Whether it wins against others at the same distance, whatever their slots.
    preferred: bool,
}

impl Best {
    pub(in crate::linkage) fn none() -> Self {
        Self {
            slot: None,
            distance: f64::INFINITY,
            preferred: false,
        }
    }

    pub(in crate::linkage) fn preferred(slot: usize, distance: f64) -> Self {
        Self {
            slot: Some(slot),
            distance,
            preferred: true,
        }
    }

    /// Takes it if it is nearer, or as near and of a lower slot.
    pub(in crate::linkage) fn offer(&mut self, slot: usize, distance: f64) {
        let is_equal = distance == self.distance && !self.preferred;
        let is_lower = self.slot.is_some_and(|best| slot < best);
        if distance < self.distance || (is_equal && is_lower) {
            *self = Self {
                slot: Some(slot),
                distance,
                preferred: false,
            };
        }
    }
}
