//! Labels of clips: a word for each clip, or none, goes in; each word once, and its number for every
//! clip, come out.

use std::collections::BTreeMap;

/// Labels of the clips of a set.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Labels {
    /// Each label once, in the order of its first clip.
    pub names: Vec<String>,
    /// The label of each clip, by its place in `names`.
    pub of_item: Vec<Option<usize>>,
}

impl Labels {
    /// The labels of clips in their order.
    pub fn new(labels: impl IntoIterator<Item = Option<String>>) -> Self {
        let mut all = Self::default();
        let mut numbers = BTreeMap::new();
        for label in labels {
            let number = label.map(|label| {
                let next = numbers.len();
                *numbers.entry(label).or_insert_with_key(|label| {
                    all.names.push(label.clone());
                    next
                })
            });
            all.of_item.push(number);
        }
        all
    }

    /// The label of a clip in words.
    pub fn of(&self, item: usize) -> Option<&str> {
        let number = (*self.of_item.get(item)?)?;
        self.names.get(number).map(String::as_str)
    }
}
