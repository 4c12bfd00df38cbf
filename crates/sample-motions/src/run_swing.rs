//! In: two stances of a foot and where the hip is at any time. Out: the foot in the swing between them.
//!
//! The leg is a hand of a clock: its turn about the hip, its length and the bend of its ankle go on from the one
//! stance and into the other, while the knee folds.

use crate::body::SHIN;
use crate::gait_foot::{FootPlace, Stance, end_of};
use crate::leg_ik;
use crate::quintic::Quintic;
use nalgebra::Vector3;

/// Of a leg, seen from its hip: turn forward, length, how far the ankle is to the left, bend of ankle and of toes.
type Leg = [f64; 5];

/// The folded leg is so much shorter, in body heights.
const FOLD: f64 = 0.185;

/// Shares of the velocities that go on: the push of the toes ends as they leave, the ground stops the leg as it strikes.
const KEPT_AT_OFF: Leg = [1.0, 0.6, 1.0, 0.4, 0.4];
const KEPT_AT_STRIKE: Leg = [0.7, 0.4, 1.0, 0.4, 1.0];
/// Accelerations as the toes leave: the leg starts to fold, in body heights per second².
const PULL_AT_OFF: Leg = [0.0, -20.0, 0.0, 0.0, 0.0];

pub struct Swing<'a> {
    pub from: &'a Stance,
    pub to: &'a Stance,
    pub hip: &'a dyn Fn(f64) -> Vector3<f64>,
}

impl Swing<'_> {
    pub fn place(&self, time_s: f64) -> FootPlace {
        let x = (time_s - self.from.off_s) / (self.to.strike_s - self.from.off_s);
        let value = |n: usize| self.join(n, time_s);
        let (turn, length) = (value(0), value(1) - FOLD * fold(x));
        let hip = (self.hip)(time_s);
        let down = Vector3::new(0.0, -libm::cos(turn), libm::sin(turn));
        let ankle = hip + down * length + Vector3::x() * value(2);
        FootPlace {
            ankle,
            pitch: shin_pitch(&hip, &ankle) + value(3),
            toes_up: value(4),
        }
    }

    fn join(&self, n: usize, time_s: f64) -> f64 {
        let leg = |stance: &Stance, time_s| leg(&(self.hip)(time_s), &stance.place(time_s))[n];
        let mut start = end_of(|t| leg(self.from, t), self.from.off_s);
        let mut end = end_of(|t| leg(self.to, t), self.to.strike_s);
        start.velocity *= KEPT_AT_OFF[n];
        end.velocity *= KEPT_AT_STRIKE[n];
        start.acceleration = PULL_AT_OFF[n];
        end.acceleration = 0.0;
        Quintic::new(self.from.off_s, start, self.to.strike_s, end).at(time_s)
    }
}

fn leg(hip: &Vector3<f64>, place: &FootPlace) -> Leg {
    let way = place.ankle - hip;
    [
        libm::atan2(way.z, -way.y),
        (way.y * way.y + way.z * way.z).sqrt(),
        way.x,
        place.pitch - shin_pitch(hip, &place.ankle),
        place.toes_up,
    ]
}

/// Tilt of the shin: positive with the foot behind the knee.
fn shin_pitch(hip: &Vector3<f64>, ankle: &Vector3<f64>) -> f64 {
    let leg = leg_ik::solve(hip, ankle, &Vector3::z());
    let down = leg.world_from_shin * Vector3::new(0.0, -SHIN, 0.0);
    libm::atan2(-down.z, -down.y)
}

/// 0 at both ends with speed and acceleration 0, 1 at three sevenths of the way: a leg folds faster than it unfolds.
fn fold(x: f64) -> f64 {
    let shape = |x: f64| x * x * x * (1.0 - x) * (1.0 - x) * (1.0 - x) * (1.0 - x);
    shape(x.clamp(0.0, 1.0)) / shape(3.0 / 7.0)
}
