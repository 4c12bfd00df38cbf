//! Which hand and foot travel farthest: the analysed frames of a human body go in one by one, the
//! joints whose trails are drawn at first come out.

use crate::body::{Body, Role};

/// Wrists, then ankles, the left ones first.
const ENDS: [Role; 4] = [
    Role::LeftWrist,
    Role::RightWrist,
    Role::LeftAnkle,
    Role::RightAnkle,
];

/// The lengths of the paths of wrists and ankles in the pelvis frame so far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Trails([f64; ENDS.len()]);

impl Trails {
    /// Takes the step from one frame to the next in: the principal joints' coordinates at both.
    pub fn add(&mut self, before: &[f64], now: &[f64]) {
        for (length, role) in self.0.iter_mut().zip(ENDS) {
            let place = 3 * role.index()..3 * role.index() + 3;
            let steps = now[place.clone()].iter().zip(&before[place]);
            let squares = steps.map(|(now, before)| (now - before) * (now - before));
            *length += squares.sum::<f64>().sqrt();
        }
    }

    /// The joints of the wrist and the ankle with the longer path, of equals the left one.
    pub fn joints(&self, body: &Body) -> Vec<usize> {
        let [left_wrist, right_wrist, left_ankle, right_ankle] = self.0;
        let wrist = ENDS[usize::from(right_wrist > left_wrist)];
        let ankle = ENDS[2 + usize::from(right_ankle > left_ankle)];
        [wrist, ankle]
            .iter()
            .filter_map(|role| body.joint(*role))
            .collect()
    }
}
