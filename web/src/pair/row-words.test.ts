import { signal } from '@preact/signals-core';
import { expect, it } from 'vitest';
import { wordsFor } from '../app/i18n/catalogue';
import { EngineError } from '../engine/types';
import type { PairClip } from './pair-clips';
import { warpingText } from './row-words';

const words = wordsFor('en');
const clip = (frames: number, kind = 'human') => ({ frames, performer: { body: { kind } } });
const human = [clip(45_000), clip(44_000)];

interface Told {
  readonly failure?: unknown;
  readonly cancelled?: boolean;
  readonly progress?: number;
}

const textOf = (state: Told, clips: readonly object[] = human): string =>
  warpingText(words, {
    clips: signal(clips as readonly PairClip[]),
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

it('says that a body is none that could be warped', () => {
  const failure = new Error('lost');
  const text = textOf({ failure }, [clip(10), clip(10, 'other')]);
  expect(text).toBe('These two cannot be compared.');
});

it('tells any other reason', () => {
  expect(textOf({ failure: new Error('lost') })).toMatch(/^B could not be warped: .*lost/);
});
