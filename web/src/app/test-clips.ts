/** Clips for tests: a name in, a clip out. */
import type { ClipResult } from '../engine/types';
import { newClip, type Clip } from './clips';

export function testClip(id: number, name: string, fields: Partial<Clip> = {}, folder = ''): Clip {
  return { ...newClip(id, { name, folder, blob: new Blob(['x']) }), ...fields };
}

/** A result of a length and a count of keyposes. */
export function testResult(frames: number, keyposes: number): ClipResult {
  const performer = { keyposes: { keyposes: new Int32Array(keyposes) }, notes: [] };
  return {
    frames,
    frameTimeS: 0.01,
    frameTimeSource: 'found',
    notes: [],
    performers: [performer],
  } as unknown as ClipResult;
}
