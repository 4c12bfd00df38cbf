import { signal } from '@preact/signals-core';
import { expect, it } from 'vitest';
import { wordsFor } from '../app/i18n/catalogue';
import { EngineError } from '../engine/types';
import type { PairClip } from './pair-clips';
import { warpingText } from './row-words';

const words = wordsFor('en');
const clips = signal([{ frames: 45_000 }, { frames: 44_000 }] as unknown as readonly PairClip[]);

const textOf = (state: { failure?: unknown; cancelled?: boolean; progress?: number }): string =>
  warpingText(words, {
    clips,
    warping: signal(null),
    warpings: {
      failure: signal(state.failure ?? null),
      cancelled: signal(state.cancelled ?? false),
      progress: signal(state.progress ?? null),
    },
  });

it('says how far the warping is, and that it was given up', () => {
  expect(textOf({ progress: 0.426 })).toBe('Warping, 42 %');
  expect(textOf({ cancelled: true })).toBe('Not warped.');
});

it('says in frames that two clips are too long for each other', () => {
  const details = ['band', '1980000000', 'at most 268435456 pairs of frames: a narrower band'];
  const failure = new EngineError({ kind: 'setting', line: null, column: null, details }, 'b.bvh');
  expect(textOf({ failure })).toBe('Too long to be warped: 45,000 by 44,000 frames.');
});

it('tells any other reason', () => {
  expect(textOf({ failure: new Error('lost') })).toMatch(/^B could not be warped: .*lost/);
});
