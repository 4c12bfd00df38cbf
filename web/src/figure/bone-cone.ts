/** In: positions of joints. Out: rounded cones between points that ride on those joints. */

export type Side = 'left' | 'right' | 'trunk';

/** The point `from + (to − from) · mix` between two joints; `mix` may lie outside 0 … 1. */
export interface ConePoint {
  readonly from: number;
  readonly to: number;
  readonly mix: number;
}

/** A cone with round ends, drawn between two points of a body; radii in body heights. */
export interface BoneCone {
  readonly start: ConePoint;
  readonly end: ConePoint;
  readonly startRadius: number;
  readonly endRadius: number;
  readonly side: Side;
  /** Cones of one limb do not darken each other and share one outline. */
  readonly limb: number;
}

/** Numbers written for one cone: start x y z radius, end x y z radius. */
export const CONE_STRIDE = 8;

export function atJoint(joint: number): ConePoint {
  return { from: joint, to: joint, mix: 0 };
}

function coordinate(point: ConePoint, joints: ArrayLike<number>, axis: number): number {
  const from = joints[point.from * 3 + axis];
  return from + (joints[point.to * 3 + axis] - from) * point.mix;
}

/** Distance between two joints of a pose. */
export function jointDistance(joints: ArrayLike<number>, a: number, b: number): number {
  return Math.hypot(
    joints[a * 3] - joints[b * 3],
    joints[a * 3 + 1] - joints[b * 3 + 1],
    joints[a * 3 + 2] - joints[b * 3 + 2],
  );
}

/**
 * Writes the cones of a pose into `out` from index `offset`, one every `stride` numbers, in the space
 * of `joints` (joints × 3); radii are multiplied by `radiusScale`. Returns the index after the last.
 */
export function writeCones(
  bones: readonly BoneCone[],
  joints: ArrayLike<number>,
  radiusScale: number,
  out: { [index: number]: number },
  offset: number,
  stride = CONE_STRIDE,
): number {
  let at = offset;
  for (let i = 0; i < bones.length; i++) {
    const bone = bones[i];
    for (let axis = 0; axis < 3; axis++) {
      out[at + axis] = coordinate(bone.start, joints, axis);
      out[at + 4 + axis] = coordinate(bone.end, joints, axis);
    }
    out[at + 3] = bone.startRadius * radiusScale;
    out[at + 7] = bone.endRadius * radiusScale;
    at += stride;
  }
  return at;
}
