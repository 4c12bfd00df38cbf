import { expect, test } from 'vitest';
import { newClip, type Clip } from '../app/clips';
import { failureOf } from '../engine/failures';
import { clipsApart } from './apart';

const clip = (of: Partial<Clip>): Clip => ({
  ...newClip(0, { name: 'a.bvh', folder: '', blob: new Blob() }),
  status: 'surveyed',
  ...of,
});
const extent = (frames: number) => ({ frames, frameTimeS: 0.1 });
const pose = failureOf('too-short-to-compare');
const prop = failureOf('not-human-to-compare');

test('each clip that cannot be compared has its reason, as soon as it has been read', () => {
  const clips = [
    clip({ extent: extent(9) }),
    clip({ extent: extent(1), incomparable: pose }),
    clip({ extent: extent(1), incomparable: prop }),
    clip({ extent: extent(0), incomparable: prop }),
    clip({ extent: extent(9), incomparable: prop, status: 'ready' }),
    clip({ extent: extent(9), incomparable: pose, status: 'ready' }),
    clip({ status: 'failed', incomparable: prop }),
    clip({ status: 'reading' }),
  ];
  expect(clipsApart(clips).map(({ reason }) => reason)).toEqual([
    'compare.apart.pose',
    'compare.apart.pose',
    'compare.apart.skeleton',
    'compare.apart.not-human',
    'compare.apart.unknown',
  ]);
});
