//! Where clips lie on the map from one comparison to the next: clips and maps go in, the map that is
//! shown comes out. A clip that arrives in between has its place at once.

use std::collections::HashMap;

use comparison::comparison::Comparison;
use comparison::distance::Distance;
use comparison::layout::Layout;
use comparison::map::{self, Map, Place};

use crate::clips::NamedClip;

/// The latest layout, and where each clip lies.
#[derive(Default)]
pub struct Places {
    layout: Option<Layout>,
    of_clip: HashMap<i32, Place>,
}

impl Places {
    /// A clip is there: it lies where it lay, or has a place on the latest layout.
    pub fn arrive(&mut self, clip: &NamedClip) {
        if let Some(layout) = &self.layout {
            let place = || layout.place(&clip.feature);
            self.of_clip.entry(clip.id).or_insert_with(place);
        }
    }

    /// A clip is gone.
    pub fn leave(&mut self, id: i32) {
        self.of_clip.remove(&id);
    }

    /// Where a clip lies.
    pub fn of(&self, clip: &NamedClip) -> Option<Place> {
        self.of_clip.get(&clip.id).copied()
    }

    /// Whether there is a layout by this distance.
    pub fn fit(&self, distance: Distance) -> bool {
        let layout = self.layout.as_ref();
        layout.is_some_and(|layout| layout.distance() == distance)
    }

    /// The map of these clips, with each where it lies; none without a layout, or where that shows too
    /// little of them.
    pub fn keep(&self, map: Map, clips: &[NamedClip]) -> Option<Map> {
        let layout = self.layout.as_ref()?;
        let place = |clip: &NamedClip| {
            let lies = self.of(clip);
            lies.unwrap_or_else(|| layout.place(&clip.feature))
        };
        map.kept_at(clips.iter().map(place).collect())
    }

    /// A clip lay here on a map that was made elsewhere.
    pub fn recall(&mut self, id: i32, place: Place) {
        self.of_clip.insert(id, place);
    }

    /// Lays out the map of a comparison as its clips lay before, and then those that have arrived since,
    /// which `told` holds too.
    pub fn lay_out(
        &mut self,
        comparison: &Comparison,
        clips: &[NamedClip],
        told: &[NamedClip],
    ) -> Map {
        let items = clips.iter().enumerate();
        let known: Vec<(usize, Place)> = items
            .filter_map(|(item, clip)| Some((item, self.of(clip)?)))
            .collect();
        let map = map::procrustes(&comparison.map, &known);
        let places = clips.iter().zip(&map.places);
        self.of_clip = places.map(|(clip, place)| (clip.id, *place)).collect();
        let (distance, distances) = (comparison.settings.distance, comparison.distances.clone());
        self.layout = Some(Layout::new(distance, distances, map.clone()));
        for clip in told {
            self.arrive(clip);
        }
        map
    }
}
