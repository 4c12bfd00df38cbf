//! In: a beat of the dance. Out: the beat as a tired dancer does it, and how she trembles.

use crate::dance_pose::{ArmPose, LegPose, Pose, Stand};
use crate::dance_steps::{Beat, SLOW};
use crate::posture::Figure;
use crate::rotation::about_x;
use nalgebra::Vector3;
use std::f64::consts::TAU;

const TEMPO: f64 = 0.85;
const AMPLITUDE: f64 = 0.8;
const STOOP_DEG: f64 = 8.0;
/// How far hips, shoulders and finger tips tremble, in body heights.
const TREMOR: f64 = 0.002;
const TREMOR_HZ: [f64; 4] = [3.1, 3.7, 4.3, 4.9];
/// Lengths over which an angle of the trunk or of an arm moves its end, in body heights.
const TRUNK: f64 = 0.297;
const ARM: f64 = 0.4;

pub fn tired(beat: &Beat) -> Beat {
    Beat {
        move_s: beat.move_s / TEMPO,
        hold_s: beat.hold_s / TEMPO,
        dip: AMPLITUDE * beat.dip,
        pose: pose(&beat.pose),
    }
}

fn pose(pose: &Pose) -> Pose {
    let smaller = |deg: [f64; 3]| deg.map(|angle| AMPLITUDE * angle);
    let [forward, right, turn] = smaller(pose.trunk_deg);
    Pose {
        weight: pose.weight,
        extension: nearer_straight(pose.extension),
        over: pose.over.map(|place| AMPLITUDE * place),
        pelvis_deg: smaller(pose.pelvis_deg),
        trunk_deg: [forward + STOOP_DEG, right, turn],
        head_deg: smaller(pose.head_deg),
        arms: pose.arms.map(|arm| self::arm(&arm)),
        legs: pose.legs.map(|leg| self::leg(&leg)),
    }
}

fn nearer_straight(extension: f64) -> f64 {
    1.0 - AMPLITUDE * (1.0 - extension)
}

/// The arm on its way from hanging.
fn arm(arm: &ArmPose) -> ArmPose {
    let hanging = &SLOW[0].pose.arms[0];
    let part = |from: f64, to: f64| from + AMPLITUDE * (to - from);
    ArmPose {
        upper: part_of_the_turn(hanging.upper, arm.upper),
        fore: part_of_the_turn(hanging.fore, arm.fore),
        supination_deg: part(hanging.supination_deg, arm.supination_deg),
        wrist_deg: part(hanging.wrist_deg, arm.wrist_deg),
    }
}

/// Steps are shorter and heels lower, a raised leg is on its way from standing.
fn leg(leg: &LegPose) -> LegPose {
    match *leg {
        LegPose::On(stand) => LegPose::On(Stand {
            x: AMPLITUDE * stand.x,
            z: AMPLITUDE * stand.z,
            turn_deg: stand.turn_deg,
            heel_deg: AMPLITUDE * stand.heel_deg,
        }),
        LegPose::Free {
            towards,
            share,
            knee,
            point_deg,
        } => LegPose::Free {
            towards: part_of_the_turn([0.0, -1.0, 0.0], towards),
            share: nearer_straight(share),
            knee,
            point_deg: AMPLITUDE * point_deg,
        },
    }
}

/// The direction at the amplitude's share of the turn from one direction to another, which is not its opposite.
fn part_of_the_turn(from: [f64; 3], to: [f64; 3]) -> [f64; 3] {
    let [from, to] = [from, to].map(|direction| Vector3::from(direction).normalize());
    let angle = libm::acos(from.dot(&to).clamp(-1.0, 1.0));
    let aside = (to - from * from.dot(&to)) / libm::sin(angle).max(1e-9);
    let turned = from * libm::cos(AMPLITUDE * angle) + aside * libm::sin(AMPLITUDE * angle);
    turned.into()
}

/// Hips, trunk and arms tremble, each in its own rhythm; always the same at the same time.
pub fn tremble(figure: &mut Figure, time_s: f64) {
    let wave = |part: usize, phase: f64| {
        let sine = |hz: f64| libm::sin(TAU * hz * time_s + phase);
        0.5 * TREMOR * (sine(TREMOR_HZ[part % 4]) + sine(TREMOR_HZ[(part + 2) % 4]))
    };
    figure.hip_middle += Vector3::new(wave(0, 0.4), 0.0, wave(1, 2.1));
    figure.trunk.forward += wave(2, 1.2) / TRUNK;
    figure.trunk.right += wave(3, 4.0) / TRUNK;
    for (side, arm) in figure.arms.iter_mut().enumerate() {
        let turn = about_x(wave(side, 2.6 + 1.9 * side as f64) / ARM);
        arm.thorax_from_upper_arm = turn * arm.thorax_from_upper_arm;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turn_is_shortened_to_four_fifths() {
        let [x, y, z] = part_of_the_turn([0.0, -1.0, 0.0], [0.0, 0.0, 2.0]);
        let (sin, cos) = libm::sincos(72.0_f64.to_radians());
        assert!(x.abs() < 1e-12 && (y + cos).abs() < 1e-12 && (z - sin).abs() < 1e-12);
        assert_eq!(
            part_of_the_turn([0.0, 1.0, 0.0], [0.0, 3.0, 0.0]),
            [0.0, 1.0, 0.0]
        );
    }

    #[test]
    fn a_beat_is_slower_smaller_and_stooped() {
        let (fresh, tired) = (SLOW[4], tired(&SLOW[4]));
        assert!((tired.move_s * 0.85 - fresh.move_s).abs() < 1e-12);
        assert!((tired.pose.trunk_deg[0] - (8.0 - 0.8 * 16.0)).abs() < 1e-12);
        assert!((tired.pose.over[1] - 0.8 * 0.215).abs() < 1e-12);
    }

    #[test]
    fn the_tremor_is_small_and_the_same_again() {
        let still = SLOW[1].pose.figure();
        let trembling = |time_s| {
            let mut figure = still;
            tremble(&mut figure, time_s);
            figure.hip_middle - still.hip_middle
        };
        for step in 0..500 {
            let moved = trembling(f64::from(step) * 0.01);
            assert!(moved.x.abs() <= 0.002 && moved.z.abs() <= 0.002);
            assert_eq!(moved, trembling(f64::from(step) * 0.01));
        }
        assert!((0..50).any(|step| trembling(f64::from(step) * 0.01).x.abs() > 0.0012));
    }
}
