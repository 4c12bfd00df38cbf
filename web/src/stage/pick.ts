/** In: a ray from the eye, the cones of a figure. Out: the cone that it meets first, and where; no three.js. */
import type { BoneCone, ConePoint } from '../figure/bone-cone';

export interface Ray {
  readonly origin: readonly [number, number, number];
  /** Of length 1. */
  readonly direction: readonly [number, number, number];
}

export interface ConeHit {
  readonly cone: number;
  /** From 0 at the cone's start to 1 at its end. */
  readonly along: number;
  /** From the eye, in body heights. */
  readonly distance: number;
}

/** Thin bones are met a little beside them too, in body heights. */
const SLACK = 0.012;

/** `data` holds a cone every `stride` numbers: start x y z radius, end x y z radius. */
export function pickCone(
  data: ArrayLike<number>,
  stride: number,
  first: number,
  count: number,
  ray: Ray,
): ConeHit | null {
  let nearest: ConeHit | null = null;
  for (let cone = 0; cone < count; cone++) {
    const hit = meet(data, (first + cone) * stride, cone, ray);
    if (hit !== null && (nearest === null || hit.distance < nearest.distance)) nearest = hit;
  }
  return nearest;
}

/** Where the ray comes nearest to the cone's axis, if that lies inside the cone. */
function meet(data: ArrayLike<number>, at: number, cone: number, ray: Ray): ConeHit | null {
  let [axisAxis, axisRay, fromAxis, fromRay] = [0, 0, 0, 0];
  for (let i = 0; i < 3; i++) {
    const axis = data[at + 4 + i] - data[at + i];
    const from = ray.origin[i] - data[at + i];
    axisAxis += axis * axis;
    axisRay += axis * ray.direction[i];
    fromAxis += from * axis;
    fromRay += from * ray.direction[i];
  }
  const bend = axisAxis - axisRay * axisRay;
  const free = bend > 1e-9 ? (fromAxis - axisRay * fromRay) / bend : 0;
  const along = Math.min(Math.max(free, 0), 1);
  const reached = along * axisRay - fromRay;
  if (reached <= 0) return null;
  let gap = 0;
  for (let i = 0; i < 3; i++) {
    const axis = data[at + 4 + i] - data[at + i];
    const off = ray.origin[i] + reached * ray.direction[i] - data[at + i] - along * axis;
    gap += off * off;
  }
  const radius = data[at + 3] + (data[at + 7] - data[at + 3]) * along;
  const reach = radius + SLACK;
  if (!(gap <= reach * reach)) return null;
  return { cone, along, distance: reached - Math.sqrt(Math.max(radius * radius - gap, 0)) };
}

/** The joint at the nearer end of a bone. */
export function jointOfHit(bone: BoneCone, along: number): number {
  return ridesOn(along < 0.5 ? bone.start : bone.end);
}

function ridesOn({ from, to, mix }: ConePoint): number {
  return mix < 0.5 ? from : to;
}
