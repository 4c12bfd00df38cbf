/**
 * In: positions in file units and world axes, the up axis, the ground. Out: the scene that every view
 * of a body shares: +Y up, the ground at 0, lengths in body heights.
 *
 * Yaw: a viewer at yaw ψ stands on the side (sin ψ, 0, cos ψ) and has (cos ψ, 0, −sin ψ) to the right.
 * Yaw 0 has world +X to the right, +Y where X is up: the convention of the core's yaws.
 */
import type { PerformerResult, UpAxis } from '../engine/types';

/** What a figure needs to know about its performer. */
export type FigurePerformer = Pick<PerformerResult, 'skeleton' | 'body' | 'up' | 'groundHeight'>;

/** For each scene axis x, y, z: which world axis it is, and its sign. Each is a rotation. */
interface AxisMap {
  readonly source: readonly [number, number, number];
  readonly sign: readonly [number, number, number];
}

const AXIS_MAPS: Readonly<Record<UpAxis, AxisMap>> = {
  '+X': { source: [1, 0, 2], sign: [1, 1, -1] },
  '-X': { source: [1, 0, 2], sign: [1, -1, 1] },
  '+Y': { source: [0, 1, 2], sign: [1, 1, 1] },
  '-Y': { source: [0, 1, 2], sign: [1, -1, -1] },
  '+Z': { source: [0, 2, 1], sign: [1, 1, -1] },
  '-Z': { source: [0, 2, 1], sign: [1, -1, 1] },
};

/** The frame in which a clip's figures stand: one for all performers of a clip. */
export interface SceneFrame {
  readonly up: UpAxis;
  /** File units along the up axis. */
  readonly groundHeight: number;
  /** File units. */
  readonly bodyHeight: number;
}

export function sceneFrameOf(performer: FigurePerformer): SceneFrame {
  const height = performer.body.height;
  return {
    up: performer.up.axis,
    groundHeight: performer.groundHeight,
    bodyHeight: height > 0 && Number.isFinite(height) ? height : 1,
  };
}

/** Writes joints × 3 positions in the scene into `out`; `pose` holds them in file units and world axes. */
export function toScene(pose: ArrayLike<number>, frame: SceneFrame, out: Float32Array): void {
  const { source, sign } = AXIS_MAPS[frame.up];
  const scale = 1 / frame.bodyHeight;
  for (let i = 0; i + 2 < pose.length; i += 3) {
    out[i] = sign[0] * pose[i + source[0]] * scale;
    out[i + 1] = (sign[1] * pose[i + source[1]] - frame.groundHeight) * scale;
    out[i + 2] = sign[2] * pose[i + source[2]] * scale;
  }
}
