/** In: a human body's principal joints, one pose. Out: its rounded cones, limb by limb. */
import type { Body, Role, Skeleton } from '../engine/types';
import { atJoint, type BoneCone, type ConePoint, jointDistance, type Side } from './bone-cone';
import { jointPath, pathFractions, pointOnPath, thinned } from './joint-path';
import { CHEST_FRACTION, RADII, spineRadius } from './radii';

/** Limb numbers: the pairs that are compared for depth stand next to each other. */
export const LIMBS = { leftLeg: 0, rightLeg: 1, leftArm: 2, rightArm: 3, trunk: 4 } as const;

/** Joints of the spine and the foot closer than this, in body heights, add nothing to the picture. */
const LEAST_SEGMENT = 0.025;
/** The centre of the head's upper ball lies this far before the head tip, in body heights. */
const HEAD_INSET = 0.025;
const HEAD_LENGTH = 0.023;
/** A tip nearer than this to the neck is not the top of the head: the head is set on by proportion. */
const LEAST_HEAD_REACH = 0.12;

type JointOf = (role: Role) => number | undefined;
type Radii = readonly [number, number];

export function humanBones(skeleton: Skeleton, body: Body, joints: ArrayLike<number>): BoneCone[] {
  const byRole = new Map(body.joints.map(({ role, joint }) => [role, joint]));
  const jointOf: JointOf = (role) => byRole.get(role);
  return [
    ...legBones('left', LIMBS.leftLeg, jointOf, skeleton, joints),
    ...legBones('right', LIMBS.rightLeg, jointOf, skeleton, joints),
    ...armBones('left', LIMBS.leftArm, jointOf),
    ...armBones('right', LIMBS.rightArm, jointOf),
    ...trunkBones(skeleton, body, jointOf, joints),
  ];
}

function cone(start: ConePoint, end: ConePoint, radii: Radii, side: Side, limb: number): BoneCone {
  return { start, end, startRadius: radii[0], endRadius: radii[1], side, limb };
}

function bone(
  from: number | undefined,
  to: number | undefined,
  radii: Radii,
  side: Side,
  limb: number,
): BoneCone[] {
  if (from === undefined || to === undefined) return [];
  return [cone(atJoint(from), atJoint(to), radii, side, limb)];
}

function legBones(
  side: 'left' | 'right',
  limb: number,
  jointOf: JointOf,
  skeleton: Skeleton,
  joints: ArrayLike<number>,
): BoneCone[] {
  const knee = jointOf(`${side}_knee`);
  const ankle = jointOf(`${side}_ankle`);
  return [
    ...bone(jointOf(`${side}_hip`), knee, RADII.thigh, side, limb),
    ...bone(knee, ankle, RADII.shin, side, limb),
    ...footBones(ankle, jointOf(`${side}_toe`), side, limb, skeleton, joints),
  ];
}

/** The foot bends at the ball where the skeleton has a joint there. */
function footBones(
  ankle: number | undefined,
  toe: number | undefined,
  side: Side,
  limb: number,
  skeleton: Skeleton,
  joints: ArrayLike<number>,
): BoneCone[] {
  if (ankle === undefined || toe === undefined) return [];
  const path = thinned(jointPath(skeleton.parents, ankle, toe), joints, LEAST_SEGMENT);
  const bent = path.length > 2 ? [path[0], path[path.length - 2], path[path.length - 1]] : path;
  const fractions = pathFractions(bent, joints);
  const radius = (i: number): number =>
    RADII.foot[0] + (RADII.foot[1] - RADII.foot[0]) * fractions[i];
  return bent
    .slice(1)
    .map((joint, i) =>
      cone(atJoint(bent[i]), atJoint(joint), [radius(i), radius(i + 1)], side, limb),
    );
}

function armBones(side: 'left' | 'right', limb: number, jointOf: JointOf): BoneCone[] {
  const elbow = jointOf(`${side}_elbow`);
  const wrist = jointOf(`${side}_wrist`);
  return [
    ...bone(jointOf(`${side}_shoulder`), elbow, RADII.upperArm, side, limb),
    ...bone(elbow, wrist, RADII.forearm, side, limb),
    ...bone(wrist, jointOf(`${side}_finger`), RADII.hand, side, limb),
  ];
}

function trunkBones(
  skeleton: Skeleton,
  body: Body,
  jointOf: JointOf,
  joints: ArrayLike<number>,
): BoneCone[] {
  const neck = jointOf('neck');
  const pelvis = bone(
    jointOf('left_hip'),
    jointOf('right_hip'),
    RADII.pelvis,
    'trunk',
    LIMBS.trunk,
  );
  if (neck === undefined) return pelvis;
  const spine = thinned(jointPath(skeleton.parents, body.pelvis, neck), joints, LEAST_SEGMENT);
  const fractions = pathFractions(spine, joints);
  const chest = pointOnPath(spine, fractions, CHEST_FRACTION);
  return [
    ...pelvis,
    ...spineBones(spine, fractions, chest),
    ...shoulderBones(chest, jointOf),
    ...headBones(neck, jointOf('head'), skeleton, joints),
  ];
}

/** At most three cones: pelvis, waist, chest, neck, on the path of the spine's joints. */
function spineBones(
  spine: readonly number[],
  fractions: readonly number[],
  chest: ConePoint,
): BoneCone[] {
  const waistFraction = CHEST_FRACTION / 2;
  const points = [
    atJoint(spine[0]),
    pointOnPath(spine, fractions, waistFraction),
    chest,
    atJoint(spine[spine.length - 1]),
  ];
  const radii = [0, waistFraction, CHEST_FRACTION, 1].map(spineRadius);
  return points
    .slice(1)
    .map((point, i) => cone(points[i], point, [radii[i], radii[i + 1]], 'trunk', LIMBS.trunk));
}

function shoulderBones(chest: ConePoint, jointOf: JointOf): BoneCone[] {
  return (['left_shoulder', 'right_shoulder'] as const).flatMap((role) => {
    const joint = jointOf(role);
    return joint === undefined
      ? []
      : [cone(chest, atJoint(joint), RADII.shoulder, 'trunk', LIMBS.trunk)];
  });
}

/** Neck and head; the head's length lies along the last bone before its tip. */
function headBones(
  neck: number,
  tip: number | undefined,
  skeleton: Skeleton,
  joints: ArrayLike<number>,
): BoneCone[] {
  if (tip === undefined || tip === neck) return [];
  const path = thinned(jointPath(skeleton.parents, neck, tip), joints, LEAST_SEGMENT);
  const base = path[path.length - 2];
  const reach = Math.max(jointDistance(joints, base, tip), 1e-3);
  const shortfall = Math.max(0, LEAST_HEAD_REACH - jointDistance(joints, neck, tip));
  const along = (length: number): ConePoint => ({
    from: base,
    to: tip,
    mix: (reach + shortfall - length) / reach,
  });
  const lower = along(HEAD_INSET + HEAD_LENGTH);
  return [
    cone(atJoint(neck), lower, RADII.neck, 'trunk', LIMBS.trunk),
    cone(lower, along(HEAD_INSET), RADII.head, 'trunk', LIMBS.trunk),
  ];
}
