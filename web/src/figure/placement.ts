/**
 * In: a pelvis over the ground, the yaw that a body faces. Out: how its scene is turned, moved or mirrored
 * to stand with other clips' bodies in one scene; lengths in body heights.
 */

/** Scene (x, z) ↦ (xx x + xz z + x, zx x + zz z + z): a turn, or a mirror and a turn, and a shift. */
export interface Placement {
  readonly xx: number;
  readonly xz: number;
  readonly zx: number;
  readonly zz: number;
  readonly x: number;
  readonly z: number;
  /** Mirrored: left and right of the body change places. */
  readonly mirrored: boolean;
}

/** As recorded. */
export const asRecorded: Placement = { xx: 1, xz: 0, zx: 0, zz: 1, x: 0, z: 0, mirrored: false };

/** Where a body is over the ground and which yaw (up-frame.ts) it faces. */
export interface Stand {
  readonly x: number;
  readonly z: number;
  readonly yawRad: number;
}

/** Brings a body that stands at `from` to `to`, facing as `to` faces; mirrored about its own forward direction. */
export function placed(from: Stand, to: Stand, mirrored: boolean): Placement {
  const turn = mirrored ? mirrorAndTurn(from.yawRad, to.yawRad) : turnBy(to.yawRad - from.yawRad);
  const { xx, xz, zx, zz } = turn;
  return {
    ...turn,
    x: to.x - xx * from.x - xz * from.z,
    z: to.z - zx * from.x - zz * from.z,
    mirrored,
  };
}

type Linear = Pick<Placement, 'xx' | 'xz' | 'zx' | 'zz'>;

/** Forward at yaw ψ is (sin ψ, cos ψ) in (x, z). */
function turnBy(rad: number): Linear {
  const [sin, cos] = [Math.sin(rad), Math.cos(rad)];
  return { xx: cos, xz: sin, zx: -sin, zz: cos };
}

/** Forward of `from` goes to forward of `to`, its right to the left there. */
function mirrorAndTurn(fromRad: number, toRad: number): Linear {
  const [sin, cos] = [Math.sin(fromRad + toRad), Math.cos(fromRad + toRad)];
  return { xx: -cos, xz: sin, zx: sin, zz: cos };
}

/** Moves joints × 3 in the scene, in place. */
export function place(joints: Float32Array, { xx, xz, zx, zz, x, z }: Placement): void {
  for (let i = 0; i + 2 < joints.length; i += 3) {
    const [px, pz] = [joints[i], joints[i + 2]];
    joints[i] = xx * px + xz * pz + x;
    joints[i + 2] = zx * px + zz * pz + z;
  }
}
