//! The choreography of the slow dance: its poses, the time to reach each and the time each is held.

use crate::body::Side::{Left, Right};
use crate::dance_pose::{ArmPose, LegPose, Pose, Stand};

/// A pose and how it is reached.
#[derive(Clone, Copy, Debug)]
pub struct Beat {
    pub move_s: f64,
    pub hold_s: f64,
    /// How far the hips sink on the way, in body heights.
    pub dip: f64,
    pub pose: Pose,
}

const fn arm(upper: [f64; 3], fore: [f64; 3], [supination_deg, wrist_deg]: [f64; 2]) -> ArmPose {
    ArmPose {
        upper,
        fore,
        supination_deg,
        wrist_deg,
    }
}

const fn on(x: f64, z: f64, turn_deg: f64, heel_deg: f64) -> LegPose {
    LegPose::On(Stand {
        x,
        z,
        turn_deg,
        heel_deg,
    })
}

const fn free(towards: [f64; 3], share: f64, knee: [f64; 3], point_deg: f64) -> LegPose {
    LegPose::Free {
        towards,
        share,
        knee,
        point_deg,
    }
}

/// Standing, thirteen poses that are held, and a rest.
pub const SLOW: [Beat; 15] = [
    // Standing, arms low.
    Beat {
        move_s: 0.0,
        hold_s: 0.0,
        dip: 0.0,
        pose: Pose {
            weight: Left,
            extension: 0.994,
            over: [0.0, 0.0],
            pelvis_deg: [3.0, 0.0, 0.0],
            trunk_deg: [0.0, 0.0, 0.0],
            head_deg: [2.0, 0.0, 0.0],
            arms: [arm([0.25, -0.97, 0.02], [0.02, -0.93, 0.35], [0.0, 10.0]); 2],
            legs: [on(0.05, 0.0, 12.0, 0.0), on(-0.05, 0.0, -12.0, 0.0)],
        },
    },
    // A wide stance, arms open to the sides.
    Beat {
        move_s: 1.1,
        hold_s: 0.09,
        dip: 0.01,
        pose: Pose {
            weight: Left,
            extension: 0.92,
            over: [0.105, 0.0],
            pelvis_deg: [2.0, 0.0, 0.0],
            trunk_deg: [-2.0, 0.0, 0.0],
            head_deg: [-4.0, 0.0, 18.0],
            arms: [arm([1.0, 0.0, 0.1], [0.93, 0.02, 0.35], [0.0, -8.0]); 2],
            legs: [on(0.26, 0.0, 22.0, 0.0), on(-0.05, 0.0, -12.0, 0.0)],
        },
    },
    // Right leg to the side, left arm overhead.
    Beat {
        move_s: 1.25,
        hold_s: 0.09,
        dip: 0.0,
        pose: Pose {
            weight: Left,
            extension: 0.994,
            over: [0.203, 0.0],
            pelvis_deg: [2.0, -14.0, 4.0],
            trunk_deg: [0.0, -4.0, 0.0],
            head_deg: [-4.0, 10.0, -12.0],
            arms: [
                arm([0.35, 0.93, 0.1], [-0.3, 0.93, 0.2], [0.0, 10.0]),
                arm([1.0, -0.1, 0.15], [0.95, 0.05, 0.35], [0.0, -10.0]),
            ],
            legs: [
                on(0.26, 0.0, 22.0, 0.0),
                free([0.8, -0.6, 0.1], 0.985, [0.35, 0.3, 0.9], 50.0),
            ],
        },
    },
    // A bow over the right leg, the left arm leading.
    Beat {
        move_s: 1.35,
        hold_s: 0.09,
        dip: 0.01,
        pose: Pose {
            weight: Right,
            extension: 0.80,
            over: [0.145, 0.17],
            pelvis_deg: [16.0, 0.0, -6.0],
            trunk_deg: [34.0, 0.0, -10.0],
            head_deg: [4.0, 0.0, 0.0],
            arms: [
                arm([0.2, 0.1, 0.97], [-0.15, -0.1, 0.97], [20.0, 6.0]),
                arm([0.75, -0.25, -0.6], [0.55, -0.35, -0.75], [0.0, 10.0]),
            ],
            legs: [on(0.26, 0.0, 22.0, 48.0), on(0.10, 0.24, -5.0, 0.0)],
        },
    },
    // Arabesque on the right leg.
    Beat {
        move_s: 1.3,
        hold_s: 0.08,
        dip: 0.0,
        pose: Pose {
            weight: Right,
            extension: 0.994,
            over: [0.145, 0.215],
            pelvis_deg: [34.0, 6.0, 0.0],
            trunk_deg: [-16.0, -2.0, 4.0],
            head_deg: [-14.0, 0.0, 0.0],
            arms: [
                arm([0.92, 0.12, -0.35], [0.85, 0.25, -0.4], [0.0, -8.0]),
                arm([0.12, 0.3, 0.95], [0.0, 0.38, 0.93], [0.0, -6.0]),
            ],
            legs: [
                free([0.14, -0.36, -0.93], 0.985, [0.55, -0.8, -0.25], 52.0),
                on(0.10, 0.24, -5.0, 0.0),
            ],
        },
    },
    // A long lunge, both arms up.
    Beat {
        move_s: 1.2,
        hold_s: 0.10,
        dip: 0.0,
        pose: Pose {
            weight: Left,
            extension: 0.86,
            over: [0.145, 0.565],
            pelvis_deg: [6.0, 0.0, 0.0],
            trunk_deg: [-12.0, 0.0, 0.0],
            head_deg: [-14.0, 0.0, 0.0],
            arms: [arm([0.5, 0.85, 0.05], [0.3, 0.93, 0.2], [0.0, -8.0]); 2],
            legs: [on(0.19, 0.74, 12.0, 0.0), on(0.10, 0.24, -5.0, 38.0)],
        },
    },
    // Standing on the left leg, right foot at the knee, arms in a ring.
    Beat {
        move_s: 1.15,
        hold_s: 0.08,
        dip: 0.0,
        pose: Pose {
            weight: Left,
            extension: 0.994,
            over: [0.142, 0.725],
            pelvis_deg: [2.0, -4.0, 0.0],
            trunk_deg: [-2.0, 0.0, 0.0],
            head_deg: [2.0, -4.0, 12.0],
            arms: [arm([0.6, 0.1, 0.75], [-0.45, 0.12, 0.88], [10.0, 12.0]); 2],
            legs: [
                on(0.19, 0.74, 12.0, 0.0),
                free([-0.13, -0.95, 0.22], 0.52, [0.72, 0.1, 0.68], 52.0),
            ],
        },
    },
    // A deep wide stance, the trunk twisted.
    Beat {
        move_s: 1.2,
        hold_s: 0.09,
        dip: 0.0,
        pose: Pose {
            weight: Right,
            extension: 0.80,
            over: [-0.035, 0.70],
            pelvis_deg: [6.0, 0.0, 6.0],
            trunk_deg: [4.0, 4.0, 42.0],
            head_deg: [-2.0, 0.0, -40.0],
            arms: [
                arm([1.0, 0.05, -0.2], [0.95, 0.2, -0.1], [0.0, -10.0]),
                arm([0.0, 0.02, 1.0], [-0.75, 0.1, 0.65], [0.0, 8.0]),
            ],
            legs: [on(0.19, 0.74, 12.0, 0.0), on(-0.24, 0.69, -28.0, 0.0)],
        },
    },
    // Left leg raised in front, right arm overhead.
    Beat {
        move_s: 1.25,
        hold_s: 0.08,
        dip: 0.0,
        pose: Pose {
            weight: Right,
            extension: 0.994,
            over: [-0.183, 0.685],
            pelvis_deg: [-8.0, 4.0, -6.0],
            trunk_deg: [-4.0, -3.0, -6.0],
            head_deg: [2.0, 0.0, 10.0],
            arms: [
                arm([0.95, -0.05, 0.2], [0.85, 0.1, 0.5], [0.0, -8.0]),
                arm([0.4, 0.9, 0.1], [-0.25, 0.93, 0.25], [0.0, 10.0]),
            ],
            legs: [
                free([0.1, -0.34, 0.93], 0.97, [0.35, 0.9, 0.25], 48.0),
                on(-0.24, 0.69, -28.0, 0.0),
            ],
        },
    },
    // Left crosses in front, arms on a diagonal.
    Beat {
        move_s: 1.2,
        hold_s: 0.09,
        dip: 0.0,
        pose: Pose {
            weight: Left,
            extension: 0.90,
            over: [-0.215, 0.86],
            pelvis_deg: [5.0, 0.0, -32.0],
            trunk_deg: [0.0, -8.0, -26.0],
            head_deg: [-10.0, 0.0, 36.0],
            arms: [
                arm([0.7, -0.6, 0.4], [0.6, -0.45, 0.66], [0.0, -6.0]),
                arm([0.7, 0.68, -0.15], [0.5, 0.86, 0.05], [0.0, -8.0]),
            ],
            legs: [on(-0.20, 0.95, -25.0, 0.0), on(-0.24, 0.69, -28.0, 36.0)],
        },
    },
    // Attitude on the left leg, the right knee bent behind.
    Beat {
        move_s: 1.2,
        hold_s: 0.08,
        dip: 0.0,
        pose: Pose {
            weight: Left,
            extension: 0.994,
            over: [-0.246, 0.915],
            pelvis_deg: [22.0, -6.0, -30.0],
            trunk_deg: [-18.0, 0.0, -6.0],
            head_deg: [-6.0, 0.0, 10.0],
            arms: [
                arm([1.0, 0.05, 0.1], [0.93, 0.1, 0.35], [0.0, -8.0]),
                arm([0.4, 0.9, 0.15], [-0.3, 0.9, 0.35], [0.0, 10.0]),
            ],
            legs: [
                on(-0.20, 0.95, -25.0, 0.0),
                free([0.25, -0.42, -0.65], 0.78, [0.85, -0.5, -0.05], 48.0),
            ],
        },
    },
    // A deep bow.
    Beat {
        move_s: 1.45,
        hold_s: 0.10,
        dip: 0.0,
        pose: Pose {
            weight: Left,
            extension: 0.88,
            over: [-0.252, 0.845],
            pelvis_deg: [46.0, 0.0, -30.0],
            trunk_deg: [46.0, 0.0, 0.0],
            head_deg: [16.0, 0.0, 0.0],
            arms: [arm([0.6, -0.7, -0.35], [0.45, -0.85, -0.1], [0.0, 6.0]); 2],
            legs: [on(-0.20, 0.95, -25.0, 0.0), on(-0.345, 0.862, -42.0, 0.0)],
        },
    },
    // On the toes, reaching up.
    Beat {
        move_s: 1.45,
        hold_s: 0.09,
        dip: 0.0,
        pose: Pose {
            weight: Left,
            extension: 0.994,
            over: [-0.304, 0.962],
            pelvis_deg: [0.0, 0.0, -32.0],
            trunk_deg: [-8.0, 0.0, 0.0],
            head_deg: [-18.0, 0.0, 0.0],
            arms: [arm([0.42, 0.9, 0.1], [0.22, 0.95, 0.1], [0.0, -6.0]); 2],
            legs: [on(-0.20, 0.95, -25.0, 48.0), on(-0.345, 0.862, -42.0, 48.0)],
        },
    },
    // Sinking, the arms crossed before the chest.
    Beat {
        move_s: 1.2,
        hold_s: 0.10,
        dip: 0.0,
        pose: Pose {
            weight: Left,
            extension: 0.86,
            over: [-0.278, 0.905],
            pelvis_deg: [8.0, 0.0, -32.0],
            trunk_deg: [10.0, 0.0, 0.0],
            head_deg: [14.0, 0.0, 0.0],
            arms: [
                arm([0.35, -0.75, 0.5], [-0.75, 0.25, 0.55], [0.0, 8.0]),
                arm([0.35, -0.65, 0.55], [-0.75, 0.4, 0.5], [0.0, 8.0]),
            ],
            legs: [on(-0.20, 0.95, -25.0, 0.0), on(-0.345, 0.862, -42.0, 0.0)],
        },
    },
    // A rest.
    Beat {
        move_s: 1.2,
        hold_s: 0.0,
        dip: 0.0,
        pose: Pose {
            weight: Left,
            extension: 0.994,
            over: [-0.246, 0.925],
            pelvis_deg: [3.0, 0.0, -30.0],
            trunk_deg: [0.0, 0.0, 0.0],
            head_deg: [2.0, 0.0, 0.0],
            arms: [arm([0.25, -0.97, 0.02], [0.02, -0.93, 0.35], [0.0, 10.0]); 2],
            legs: [on(-0.20, 0.95, -25.0, 0.0), on(-0.292, 0.892, -38.0, 0.0)],
        },
    },
];
