/** Clips for tests: a name in, a clip out. */
import type { ClipResult } from '../engine/types';
import { newClip, type Clip } from './clips';

export function testClip(id: number, name: string, fields: Partial<Clip> = {}, folder = ''): Clip {
  const extent = fields.result ?? null;
  return { ...newClip(id, { name, folder, blob: new Blob(['x']) }), extent, ...fields };
}

/** A result of a length and a count of keyposes. */
export function testResult(frames: number, keyposes: number): ClipResult {
  const performer = {
    keyposes: { keyposes: new Int32Array(keyposes) },
    notes: [],
    body: { kind: 'human' },
    comparable: null,
  };
  return {
    frames,
    frameTimeS: 0.01,
    frameTimeSource: 'found',
    notes: [],
    performers: [performer],
    thumbnailPose: new Float32Array(),
  } as unknown as ClipResult;
}
