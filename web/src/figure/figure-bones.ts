/** In: a performer's skeleton and body, one pose in body heights. Out: the rounded cones of its figure. */
import type { Body, Skeleton } from '../engine/types';
import type { BoneCone, Side } from './bone-cone';
import { humanBones } from './human-bones';
import { plainBones } from './plain-bones';

/**
 * The figure of a body. `joints` (joints × 3, in the scene of up-frame.ts) is any one pose: it tells
 * where on the spine the joints lie and how far the head reaches.
 */
export function figureBones(skeleton: Skeleton, body: Body, joints: ArrayLike<number>): BoneCone[] {
  const bones = body.kind === 'human' ? humanBones(skeleton, body, joints) : [];
  return bones.length > 0 ? bones : plainBones(skeleton);
}

const otherSide: Readonly<Record<Side, Side>> = { left: 'right', right: 'left', trunk: 'trunk' };

/** The bones of a mirror image: its left arm is a right one. */
export function mirroredBones(bones: readonly BoneCone[]): BoneCone[] {
  return bones.map((bone) => ({ ...bone, side: otherSide[bone.side] }));
}
