//! In: where and when a foot stands. Out: its ankle, tilt and toes at any time of a walk or of a stance of a run.
//!
//! A stance is three rockers: the heel strikes with the toes up and the foot comes down about the heel; it stands
//! flat; it rises about the ball while the toes stay. A walk's swing joins the ends of two stances with equal
//! position, velocity and acceleration; only the brake of the heel strike is a jump of the acceleration.

use crate::body::{ANKLE, BALL_FROM_ANKLE, HEEL_FROM_ANKLE};
use crate::quintic::{End, Quintic, detour};
use crate::rotation::about_x;
use nalgebra::Vector3;

/// The mid-swing rise of the ankle above the joining curve, in body heights.
const SWING_LIFT: f64 = 0.030;
/// The ground stops the foot so hard, in body heights per second².
const STRIKE_BRAKE: f64 = 16.0;
const DIFFERENCE_S: f64 = 1e-3;

/// How a foot rolls over the ground; tilts in radians, positive with the heel above the toes.
#[derive(Clone, Copy, Debug)]
pub struct Rockers {
    pub strike_pitch: f64,
    /// Radians per second at the strike.
    pub strike_pitch_rate: f64,
    pub heel_s: f64,
    pub forefoot_s: f64,
    /// Tilt per second as the toes leave, as a multiple of the tilt.
    pub off_pitch_rate: f64,
}

/// A time on the ground.
#[derive(Clone, Copy, Debug)]
pub struct Stance {
    /// Heel strike; before the clip for a foot that stands at its start.
    pub strike_s: f64,
    pub off_s: f64,
    /// The ankle's place while the foot is flat.
    pub x: f64,
    pub z: f64,
    /// Tilt as the toes leave, in radians.
    pub off_pitch: f64,
    pub rockers: Rockers,
}

/// Ankle in the world, tilt (positive: heel above toes) and bend of the toes, in radians.
#[derive(Clone, Copy, Debug)]
pub struct FootPlace {
    pub ankle: Vector3<f64>,
    pub pitch: f64,
    pub toes_up: f64,
}

impl Stance {
    fn pitch(&self, time_s: f64) -> f64 {
        let rockers = &self.rockers;
        let flat_s = self.strike_s + rockers.heel_s;
        let rise_s = self.off_s - rockers.forefoot_s;
        if time_s < flat_s {
            let strike = End::moving(rockers.strike_pitch, rockers.strike_pitch_rate);
            Quintic::new(self.strike_s, strike, flat_s, End::at_rest(0.0)).at(time_s)
        } else if time_s > rise_s {
            let off = End::moving(self.off_pitch, rockers.off_pitch_rate * self.off_pitch);
            Quintic::new(rise_s, End::at_rest(0.0), self.off_s, off).at(time_s)
        } else {
            0.0
        }
    }

    /// The foot as it stands; also a little before and after the stance.
    pub fn place(&self, time_s: f64) -> FootPlace {
        let pitch = self.pitch(time_s);
        let pivot = if pitch < 0.0 {
            HEEL_FROM_ANKLE
        } else {
            BALL_FROM_ANKLE
        };
        let flat = Vector3::new(self.x, ANKLE[1], self.z);
        let ankle = flat + pivot - about_x(pitch) * pivot;
        FootPlace {
            ankle,
            pitch,
            toes_up: pitch.max(0.0),
        }
    }
}

/// A foot's stances in order of time.
#[derive(Clone, Debug)]
pub struct FootTrack {
    pub stances: Vec<Stance>,
}

/// What a foot does at a time.
#[derive(Clone, Copy, Debug)]
pub enum Phase<'a> {
    Stands(&'a Stance),
    /// From one stance to the next.
    Swings(&'a Stance, &'a Stance),
}

impl FootTrack {
    pub fn phase(&self, time_s: f64) -> Phase<'_> {
        let next = self.stances.iter().position(|stance| stance.off_s > time_s);
        let Some(next) = next else {
            return Phase::Stands(&self.stances[self.stances.len() - 1]);
        };
        let to = &self.stances[next];
        if time_s >= to.strike_s || next == 0 {
            return Phase::Stands(to);
        }
        Phase::Swings(&self.stances[next - 1], to)
    }

    /// The foot of a walk.
    pub fn place(&self, time_s: f64) -> FootPlace {
        match self.phase(time_s) {
            Phase::Stands(stance) => stance.place(time_s),
            Phase::Swings(from, to) => swing(from, to, time_s),
        }
    }
}

fn swing(from: &Stance, to: &Stance, time_s: f64) -> FootPlace {
    let join = |value: &dyn Fn(FootPlace) -> f64, brake: f64| {
        let start = end_of(|t| value(from.place(t)), from.off_s);
        let mut end = end_of(|t| value(to.place(t)), to.strike_s);
        end.acceleration -= brake;
        Quintic::new(from.off_s, start, to.strike_s, end).at(time_s)
    };
    let x = (time_s - from.off_s) / (to.strike_s - from.off_s);
    let z = join(&|place| place.ankle.z, STRIKE_BRAKE);
    let y = join(&|place| place.ankle.y, 0.0) + SWING_LIFT * detour(x);
    FootPlace {
        ankle: Vector3::new(to.x, y, z),
        pitch: join(&|place| place.pitch, 0.0),
        toes_up: join(&|place| place.toes_up, 0.0),
    }
}

/// Position, velocity and acceleration of a smooth value at a time.
pub fn end_of(value: impl Fn(f64) -> f64, time_s: f64) -> End {
    let [before, position, after] =
        [-DIFFERENCE_S, 0.0, DIFFERENCE_S].map(|step| value(time_s + step));
    End {
        position,
        velocity: (after - before) / (2.0 * DIFFERENCE_S),
        acceleration: (after - 2.0 * position + before) / (DIFFERENCE_S * DIFFERENCE_S),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::BALL;

    fn track() -> FootTrack {
        let stance = |strike_s: f64, z| Stance {
            strike_s,
            off_s: strike_s + 0.67,
            x: 0.04,
            z,
            off_pitch: 1.0,
            rockers: Rockers {
                strike_pitch: -0.3,
                strike_pitch_rate: 1.6,
                heel_s: 0.11,
                forefoot_s: 0.3,
                off_pitch_rate: 5.5,
            },
        };
        FootTrack {
            stances: vec![stance(0.0, 0.0), stance(1.1, 0.8)],
        }
    }

    #[test]
    fn the_sole_stays_where_it_stands() {
        for step in 0..=67 {
            let place = track().place(f64::from(step) * 0.01);
            let point = |p: Vector3<f64>| place.ankle + about_x(place.pitch) * p;
            let (heel, ball) = (point(HEEL_FROM_ANKLE), point(BALL_FROM_ANKLE));
            let pivot = if place.pitch < 0.0 {
                heel.z + 0.028
            } else {
                ball.z - 0.078
            };
            assert!(pivot.abs() < 1e-12, "{pivot} at {step}");
            assert!(heel.y > -1e-12 && ball.y > BALL[1] - 1e-12);
        }
    }

    #[test]
    fn a_swing_is_smooth_and_clears_the_ground() {
        let track = track();
        let mut before = track.place(0.0).ankle;
        for step in 1..=1500 {
            let place = track.place(f64::from(step) * 1e-3);
            assert!((place.ankle - before).norm() < 0.005, "jump at {step} ms");
            let ball = place.ankle + about_x(place.pitch) * BALL_FROM_ANKLE;
            assert!(
                ball.y > BALL[1] - 1e-3,
                "ball {} below the ground at {step} ms",
                ball.y
            );
            before = place.ankle;
        }
    }
}
