/** Small bodies for the tests of figures: made by hand, 2 file units tall, standing at the origin. */
import type { Body, Role, Skeleton } from '../engine/types';
import type { FigurePerformer } from './up-frame';

type JointRow = readonly [
  label: string,
  parent: number,
  x: number,
  y: number,
  z: number,
  role?: Role,
];

/** Facing +Z, so that the body's left is at +X; arms straight out. */
const STANDING: readonly JointRow[] = [
  ['Hips', -1, 0, 1, 0],
  ['Spine', 0, 0, 1.2, 0],
  ['Chest', 1, 0, 1.45, 0],
  ['Neck', 2, 0, 1.6, 0, 'neck'],
  ['Head', 3, 0, 1.75, 0],
  ['Head/end', 4, 0, 1.95, 0, 'head'],
  ['LeftArm', 2, 0.25, 1.55, 0, 'left_shoulder'],
  ['LeftForeArm', 6, 0.6, 1.55, 0, 'left_elbow'],
  ['LeftHand', 7, 0.9, 1.55, 0, 'left_wrist'],
  ['LeftHand/end', 8, 1.05, 1.55, 0, 'left_finger'],
  ['RightArm', 2, -0.25, 1.55, 0, 'right_shoulder'],
  ['RightForeArm', 10, -0.6, 1.55, 0, 'right_elbow'],
  ['RightHand', 11, -0.9, 1.55, 0, 'right_wrist'],
  ['RightHand/end', 12, -1.05, 1.55, 0, 'right_finger'],
  ['LeftUpLeg', 0, 0.15, 1, 0, 'left_hip'],
  ['LeftLeg', 14, 0.15, 0.55, 0, 'left_knee'],
  ['LeftFoot', 15, 0.15, 0.1, 0, 'left_ankle'],
  ['LeftToeBase', 16, 0.15, 0.02, 0.15],
  ['LeftToeBase/end', 17, 0.15, 0.02, 0.25, 'left_toe'],
  ['RightUpLeg', 0, -0.15, 1, 0, 'right_hip'],
  ['RightLeg', 19, -0.15, 0.55, 0, 'right_knee'],
  ['RightFoot', 20, -0.15, 0.1, 0, 'right_ankle'],
  ['RightToeBase', 21, -0.15, 0.02, 0.15],
  ['RightToeBase/end', 22, -0.15, 0.02, 0.25, 'right_toe'],
];

export const standingPose: Float32Array = Float32Array.from(
  STANDING.flatMap(([, , x, y, z]) => [x, y, z]),
);

const skeleton: Skeleton = {
  labels: STANDING.map(([label]) => label),
  parents: Int32Array.from(STANDING, ([, parent]) => parent),
  endSites: Uint8Array.from(STANDING, ([label]) => (label.endsWith('/end') ? 1 : 0)),
};

const humanBody: Body = {
  kind: 'human',
  pelvis: 0,
  height: 2,
  joints: STANDING.flatMap(([, , , , , role], joint) =>
    role ? [{ role, joint, source: 'name' as const }] : [],
  ),
};

const up = { axis: '+Y', source: 'found' } as const;

export const human: FigurePerformer = { skeleton, body: humanBody, up, groundHeight: 0 };

/** The same joints, taken for an animal. */
export const animal: FigurePerformer = {
  skeleton,
  body: { kind: 'other', pelvis: 0, height: 2, joints: [] },
  up,
  groundHeight: 0,
};
