/** The two readers of BVH: bytes of a whole file go in, its channels come out, in each one's own form. */
import { BVHLoader } from 'three/addons/loaders/BVHLoader.js';
import type { Core, CoreClip } from '../../web/src/engine/raw';
import { SLICE_BYTES } from '../../web/src/engine/slices';

/** A clip read by Keypose, in slices as the app reads it; whoever reads it frees it. */
export function readByKeypose(core: Core, bytes: Uint8Array): CoreClip {
  const clip = core.newClip();
  clip.beginReading(bytes.length);
  for (let at = 0; at < bytes.length; at += SLICE_BYTES) {
    clip.push(bytes.subarray(at, at + SLICE_BYTES));
  }
  clip.endReading();
  return clip;
}

/** What three.js makes of the same bytes: it reads text, so the bytes are decoded first. */
export function readByThree(bytes: Uint8Array<ArrayBuffer>): unknown {
  return new BVHLoader().parse(new TextDecoder().decode(bytes));
}

/** Poses made at a time. */
const POSES_AT_ONCE = 4_000;

function framesOf(bytes: Uint8Array<ArrayBuffer>): number {
  const head = new TextDecoder().decode(bytes.subarray(0, 100_000));
  return Number(/^Frames:\s*(\d+)/m.exec(head)?.[1]);
}

/** The position of every joint at every frame of a clip just read from `bytes`; frees the clip. */
export function poseAll(clip: CoreClip, bytes: Uint8Array<ArrayBuffer>): void {
  const frames = framesOf(bytes);
  for (let first = 0; first < frames; first += POSES_AT_ONCE) {
    clip.poseRange(0, first, Math.min(POSES_AT_ONCE, frames - first));
  }
  clip.free();
}
