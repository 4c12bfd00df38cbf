//! In: two poses and a time. Out: the figure on its way.
//!
//! Weight first, feet later: the hips are over the new support before the other foot leaves, and a foot
//! is down before the hips follow it. Each link further out starts and arrives a little later.

use crate::body::{BALL, BALL_FROM_ANKLE, Side, TOE_TIP};
use crate::dance_pose::{Stand, hip_height};
use crate::leg_ik::REACH;
use crate::posture::{Bend, Figure, Foot};
use crate::quintic::{detour, minimum_jerk};
use crate::rotation::{Rotation, about_x, from_columns, slerp};
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// Seconds by which the links follow the pelvis.
const TRUNK_LAG_S: f64 = 0.02;
const HEAD_LAG_S: f64 = 0.04;
const ARM_LAGS_S: [f64; 3] = [0.04, 0.06, 0.08];
/// When the last link has arrived.
pub const LAST_LAG_S: f64 = ARM_LAGS_S[2];

/// Parts of a move, from 0 to 1, in which the hips and the foot travel.
const EVENLY: [f64; 2] = [0.0, 1.0];
const HIPS_BEFORE_LIFT: [f64; 2] = [0.0, 0.84];
const FOOT_LIFTS: [f64; 2] = [0.12, 1.0];
const HIPS_AFTER_LANDING: [f64; 2] = [0.08, 1.0];
const FOOT_LANDS: [f64; 2] = [0.0, 0.84];
const FOOT_STEPS: [f64; 2] = [0.08, 0.88];
/// A leg is so much shorter in the middle of its way, in body heights: always, and for each radian that it turns.
const FOOT_CLEARANCE: f64 = 0.015;
const FOOT_CLEARANCE_PER_RADIAN: f64 = 0.055;
/// The toes pass over the ground at this height, in body heights.
const GROUND_CLEARANCE: f64 = 0.03;
/// How softly a leg that is nearly straight holds the hips down, in body heights.
const SOFTNESS: f64 = 0.004;

/// A pose with its times; `stands` holds the feet on the ground, `dip` belongs to the move to it.
pub struct Key {
    pub figure: Figure,
    pub stands: [Option<Stand>; 2],
    pub arrive_s: f64,
    pub leave_s: f64,
    pub dip: f64,
}

/// The way from one pose to the next; also the hold that follows.
pub struct Move<'a> {
    pub from: &'a Key,
    pub to: &'a Key,
    pub time_s: f64,
}

impl Move<'_> {
    /// Share of the time, for a link that follows by `lag_s`.
    fn time_share(&self, lag_s: f64) -> f64 {
        (self.time_s - lag_s - self.from.leave_s) / (self.to.arrive_s - self.from.leave_s)
    }

    /// Share of the way, for a part that travels in a window of the move.
    fn share(&self, [from, to]: [f64; 2], lag_s: f64) -> f64 {
        minimum_jerk((self.time_share(lag_s) - from) / (to - from))
    }

    /// The figure before its feet are set: hips, trunk and arms on their way.
    pub fn carried(&self) -> Figure {
        let (a, b) = (&self.from.figure, &self.to.figure);
        let turn = self.share(EVENLY, 0.0);
        let follow = ARM_LAGS_S.map(|lag_s| self.share(EVENLY, lag_s));
        let mut figure = Figure {
            hip_middle: self.hip_middle(),
            world_from_pelvis: slerp(&a.world_from_pelvis, &b.world_from_pelvis, turn),
            trunk: a.trunk.towards(&b.trunk, self.share(EVENLY, TRUNK_LAG_S)),
            head: a.head.towards(&b.head, self.share(EVENLY, HEAD_LAG_S)),
            arms: [0, 1].map(|n| a.arms[n].towards(&b.arms[n], follow)),
            feet: a.feet,
        };
        breathe(&mut figure, self.time_s, detour(self.time_share(0.0)));
        figure
    }

    /// Stands it on the ground: the hips as high as the legs let them, then the feet.
    pub fn stand(&self, figure: &mut Figure) {
        self.hold_down(figure);
        figure.feet = Side::BOTH.map(|side| self.foot(figure, side));
    }

    fn hip_middle(&self) -> Vector3<f64> {
        let (a, b) = (&self.from.figure.hip_middle, &self.to.figure.hip_middle);
        let across = self.share(self.hips_window(), 0.0);
        let up = self.share(EVENLY, 0.0);
        let mut hips = a + (b - a) * across;
        hips.y = a.y + (b.y - a.y) * up - self.to.dip * detour(self.time_share(0.0));
        hips
    }

    fn hips_window(&self) -> [f64; 2] {
        let single = |key: &Key| key.stands.contains(&None);
        match (single(self.from), single(self.to)) {
            (false, true) => HIPS_BEFORE_LIFT,
            (true, false) => HIPS_AFTER_LANDING,
            _ => EVENLY,
        }
    }

    /// Both stands of a foot that stays on its ball.
    fn stays(&self, side: Side) -> Option<[Stand; 2]> {
        let [a, b] = [self.from, self.to].map(|key| key.stands[side as usize]);
        match (a, b) {
            (Some(a), Some(b)) if a.same_place(&b) => Some([a, b]),
            _ => None,
        }
    }

    fn foot_share(&self, side: Side) -> f64 {
        let [a, b] = [self.from, self.to].map(|key| key.stands[side as usize].is_some());
        let window = match (a, b) {
            (true, false) => FOOT_LIFTS,
            (false, true) => FOOT_LANDS,
            _ => FOOT_STEPS,
        };
        self.share(window, 0.0)
    }

    /// Lowers the hips to where the legs on the ground reach.
    fn hold_down(&self, figure: &mut Figure) {
        for side in Side::BOTH {
            let (ankle, slack) = self.anchor(side);
            let limit = hip_height(figure, side, &ankle, REACH) + slack;
            figure.hip_middle.y -= excess(figure.hip_middle.y - limit, SOFTNESS);
        }
    }

    /// The ankle that holds the hips, and by how much it already lets them go.
    fn anchor(&self, side: Side) -> (Vector3<f64>, f64) {
        if let Some(stands) = self.stays(side) {
            return (self.standing(stands).ankle, 0.0);
        }
        let share = self.foot_share(side);
        let stands = |key: &Key| key.stands[side as usize].is_some();
        let foot = |key: &Key| key.figure.feet[side as usize].ankle;
        match (stands(self.from), stands(self.to)) {
            (true, false) => (foot(self.from), share),
            (false, true) => (foot(self.to), 1.0 - share),
            _ if share < 0.5 => (foot(self.from), share),
            _ => (foot(self.to), 1.0 - share),
        }
    }

    fn standing(&self, [a, b]: [Stand; 2]) -> Foot {
        let heel_deg = a.heel_deg + (b.heel_deg - a.heel_deg) * self.share(EVENLY, 0.0);
        Stand { heel_deg, ..a }.foot()
    }

    fn foot(&self, figure: &Figure, side: Side) -> Foot {
        match self.stays(side) {
            Some(stands) => self.standing(stands),
            None => self.travelling(figure, side),
        }
    }

    /// A foot that stands starts and ends in the world, one in the air goes with the hip.
    fn travelling(&self, figure: &Figure, side: Side) -> Foot {
        let share = self.foot_share(side);
        let hip = figure.hip(side);
        let [from, to] = [self.from, self.to].map(|key| &key.figure.feet[side as usize]);
        let [a, b] = [self.from, self.to].map(|key| from_hip(key, side, &hip));
        let [turn_a, turn_b] = [
            leg_frame(&a, &from.knee_towards),
            leg_frame(&b, &to.knee_towards),
        ];
        let turn = slerp(&turn_a, &turn_b, share);
        let aside = 4.0 * share * (1.0 - share);
        let angle = libm::acos((a.dot(&b) / (a.norm() * b.norm())).clamp(-1.0, 1.0));
        let shorter = (FOOT_CLEARANCE + FOOT_CLEARANCE_PER_RADIAN * angle) * aside;
        let length = a.norm() + (b.norm() - a.norm()) * share - shorter;
        let length = length - excess(length - REACH, 4.0 * SOFTNESS * aside);
        let pointed = about_x(0.45 * aside);
        let mut foot = Foot {
            ankle: hip - turn * Vector3::y() * length,
            world_from_foot: slerp(&from.world_from_foot, &to.world_from_foot, share) * pointed,
            knee_towards: turn * Vector3::z(),
            toes_up: from.toes_up + (to.toes_up - from.toes_up) * share,
        };
        let below = BALL[1] + GROUND_CLEARANCE * aside - lowest(&foot);
        foot.ankle.y += excess(below, 2.0 * GROUND_CLEARANCE * aside);
        foot
    }
}

/// The part of `over` above 0, rounded off over about `softness`.
fn excess(over: f64, softness: f64) -> f64 {
    0.5 * (over + (over * over + softness * softness).sqrt())
}

/// Height of the lowest point of the ball and the tip of the toes.
fn lowest(foot: &Foot) -> f64 {
    let ball = foot.ankle + foot.world_from_foot * BALL_FROM_ANKLE;
    let toes = Vector3::new(0.0, TOE_TIP[1] - BALL[1], TOE_TIP[2] - BALL[2]);
    let tip = ball + foot.world_from_foot * (about_x(-foot.toes_up) * toes);
    ball.y.min(tip.y + BALL[1] - TOE_TIP[1])
}

/// The ankle from the hip: of a foot that stands from where the hip is now, of one in the air as in its pose.
fn from_hip(key: &Key, side: Side, hip: &Vector3<f64>) -> Vector3<f64> {
    let foot = &key.figure.feet[side as usize];
    let stands = key.stands[side as usize].is_some();
    foot.ankle - if stands { *hip } else { key.figure.hip(side) }
}

/// The turn of a leg as a whole: −y to the ankle, z to where the knee shows.
fn leg_frame(from_hip: &Vector3<f64>, knee_towards: &Vector3<f64>) -> Rotation {
    let y = -from_hip.normalize();
    let x = y.cross(knee_towards).normalize();
    from_columns(x, y, x.cross(&y))
}

/// Breath and sway, to a part `depth`; in a hold the breath is held.
fn breathe(figure: &mut Figure, time_s: f64, depth: f64) {
    let wave =
        |frequency_hz: f64, phase: f64| depth * libm::sin(TAU * frequency_hz * time_s + phase);
    let sway = Bend {
        forward: 0.007 * wave(0.27, 0.0),
        right: 0.005 * wave(0.19, 1.0),
        turn: 0.0,
    };
    figure.trunk = Bend {
        forward: figure.trunk.forward + sway.forward,
        right: figure.trunk.right + sway.right,
        turn: figure.trunk.turn,
    };
    figure.head.forward -= sway.forward;
    for arm in &mut figure.arms {
        arm.elbow += 0.012 * wave(0.27, 2.0);
    }
}
