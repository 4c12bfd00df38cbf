/** In: one pose, its performer, a yaw. Out: a flat figure: limbs from far to near, in body heights. */
import type { BoneCone, Side } from './bone-cone';
import { CONE_STRIDE, writeCones } from './bone-cone';
import { figureBones, mirroredBones } from './figure-bones';
import { LIMBS } from './human-bones';
import { place, type Placement } from './placement';
import { type FigurePerformer, sceneFrameOf, toScene } from './up-frame';

/** The viewer looks down a little, so that feet on the ground do not lie on one line. */
const PITCH_RAD = 0.08;
/** A limb is the farther of its pair when it lies deeper by more than this, in body heights. */
const FARTHER_BY = 0.035;
/** Numbers of one flat cone: start x, y, radius, end x, y, radius; y grows upward from the ground. */
export const FLAT_STRIDE = 6;

/** One limb: the union of its flat cones is its outline. */
export interface FlatLimb {
  readonly side: Side;
  /** The farther of a pair of arms or legs: drawn darker. */
  readonly far: boolean;
  /** Larger is nearer to the viewer. */
  readonly depth: number;
  readonly cones: Float32Array;
}

/** A figure whose pelvis stands over x = 0 and whose ground is y = 0; lengths in body heights. */
export interface FlatFigure {
  /** From far to near. */
  readonly limbs: readonly FlatLimb[];
  readonly minX: number;
  readonly maxX: number;
  readonly minY: number;
  readonly maxY: number;
}

interface Gathering {
  readonly side: Side;
  readonly limb: number;
  readonly cones: number[];
  depthSum: number;
}

/**
 * The figure of `pose` (joints × 3, file units, world axes) for a viewer at `yawRad` (up-frame.ts).
 * All figures of a performer share one scale and one ground line: a leap leaves the ground. `placement`
 * turns or mirrors the body first.
 */
export function flatFigure(
  pose: ArrayLike<number>,
  performer: FigurePerformer,
  yawRad: number,
  placement?: Placement,
): FlatFigure {
  const joints = new Float32Array(pose.length);
  toScene(pose, sceneFrameOf(performer), joints);
  if (placement) place(joints, placement);
  const recorded = figureBones(performer.skeleton, performer.body, joints);
  const bones = placement?.mirrored ? mirroredBones(recorded) : recorded;
  const cones = new Float32Array(bones.length * CONE_STRIDE);
  writeCones(bones, joints, 1, cones, 0);
  const pelvis = Math.max(0, performer.body.pelvis) * 3;
  const projection = new Projection(yawRad, joints[pelvis] ?? 0, joints[pelvis + 2] ?? 0);
  const limbs = markFarther(gatherLimbs(bones, cones, projection));
  return { limbs: limbs.sort((a, b) => a.depth - b.depth), ...extent(limbs) };
}

class Projection {
  private readonly cosYaw: number;
  private readonly sinYaw: number;
  private readonly cosPitch = Math.cos(PITCH_RAD);
  private readonly sinPitch = Math.sin(PITCH_RAD);

  private readonly centreX: number;
  private readonly centreZ: number;

  constructor(yawRad: number, centreX: number, centreZ: number) {
    this.centreX = centreX;
    this.centreZ = centreZ;
    this.cosYaw = Math.cos(yawRad);
    this.sinYaw = Math.sin(yawRad);
  }

  /** Appends x, y, radius of a ball of `cones` to `out`; returns its depth. */
  ball(cones: Float32Array, at: number, out: number[]): number {
    const x = cones[at] - this.centreX;
    const y = cones[at + 1];
    const z = cones[at + 2] - this.centreZ;
    const toward = this.sinYaw * x + this.cosYaw * z;
    out.push(
      this.cosYaw * x - this.sinYaw * z,
      y * this.cosPitch - toward * this.sinPitch,
      cones[at + 3],
    );
    return toward * this.cosPitch + y * this.sinPitch;
  }
}

function gatherLimbs(
  bones: readonly BoneCone[],
  cones: Float32Array,
  projection: Projection,
): Gathering[] {
  const limbs = new Map<number, Gathering>();
  const human = bones.some((bone) => bone.side !== 'trunk');
  bones.forEach((bone, i) => {
    // Places beyond what 32 bits hold cannot be drawn.
    const first = i * CONE_STRIDE;
    if (!cones.subarray(first, first + CONE_STRIDE).every(Number.isFinite)) return;
    // Plain bones are one outline: halos would cut it into dashes.
    const number = human ? bone.limb : LIMBS.trunk;
    let limb = limbs.get(number);
    if (!limb)
      limbs.set(number, (limb = { side: bone.side, limb: number, cones: [], depthSum: 0 }));
    limb.depthSum += projection.ball(cones, first, limb.cones);
    limb.depthSum += projection.ball(cones, first + 4, limb.cones);
  });
  return [...limbs.values()];
}

function markFarther(limbs: readonly Gathering[]): FlatLimb[] {
  const depthOf = (limb: Gathering): number => (limb.depthSum * 3) / limb.cones.length;
  return limbs.map((limb) => {
    // Limb numbers of a pair differ in their last bit.
    const other =
      limb.limb < LIMBS.trunk ? limbs.find((l) => l.limb === (limb.limb ^ 1)) : undefined;
    const far = other !== undefined && depthOf(other) - depthOf(limb) > FARTHER_BY;
    return { side: limb.side, far, depth: depthOf(limb), cones: Float32Array.from(limb.cones) };
  });
}

function extent(limbs: readonly FlatLimb[]): Omit<FlatFigure, 'limbs'> {
  let minX = Infinity,
    maxX = -Infinity,
    minY = Infinity,
    maxY = -Infinity;
  for (const { cones } of limbs) {
    for (let i = 0; i + 2 < cones.length; i += 3) {
      const x = cones[i],
        y = cones[i + 1],
        radius = cones[i + 2];
      minX = Math.min(minX, x - radius);
      maxX = Math.max(maxX, x + radius);
      minY = Math.min(minY, y - radius);
      maxY = Math.max(maxY, y + radius);
    }
  }
  return limbs.length > 0 ? { minX, maxX, minY, maxY } : { minX: 0, maxX: 0, minY: 0, maxY: 0 };
}
