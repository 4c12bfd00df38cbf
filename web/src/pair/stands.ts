/**
 * The clips of the page in; how each stands in the scene out: all face as A does, so that one view shows
 * the same side of every body.
 */
import { asRecorded, placed, type Placement } from '../figure/placement';
import { sceneFrameOf, toScene } from '../figure/up-frame';
import type { PairClip } from './pair-clips';

/** The yaw of the widest side from which a body faces to the right rather than to the left. */
export function sideYaw({ performer: { sideYawRad, frontYawRad } }: PairClip): number {
  return Math.sin(frontYawRad - sideYawRad) < 0 ? sideYawRad + Math.PI : sideYawRad;
}

/** The yaw from which a clip's flat figures show the side that A's show. */
export function pairYaw(a: PairClip, { performer }: PairClip): number {
  return performer.frontYawRad + sideYaw(a) - a.performer.frontYawRad;
}

/** A clip on a stage of its own. */
export function standAlone(a: PairClip, clip: PairClip, mirrored: boolean): Placement {
  if (clip.id === a.id) return asRecorded;
  const [from, to] = [clip, a].map(({ performer }) => ({
    x: 0,
    z: 0,
    yawRad: performer.frontYawRad,
  }));
  return placed(from, to, mirrored);
}

/** A clip beside A on one stage: at the moment given its pelvis stands where A's does. */
export function standTogether(
  a: PairClip,
  clip: PairClip,
  poseOfA: Float32Array,
  pose: Float32Array,
  mirrored: boolean,
): Placement {
  if (clip.id === a.id) return asRecorded;
  return placed(standOf(clip, pose), standOf(a, poseOfA), mirrored);
}

function standOf({ performer }: PairClip, pose: Float32Array) {
  const joints = new Float32Array(pose.length);
  toScene(pose, sceneFrameOf(performer), joints);
  const pelvis = 3 * Math.max(0, performer.body.pelvis);
  return { x: joints[pelvis] ?? 0, z: joints[pelvis + 2] ?? 0, yawRad: performer.frontYawRad };
}
