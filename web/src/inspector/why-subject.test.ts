import { expect, test } from 'vitest';
import type { KeyposeResult } from '../engine/types';
import { whySubject } from './why-subject';

const result = {
  candidates: Int32Array.of(5, 9, 14, 20, 31),
  intensities: Float64Array.of(2, 0, 7, 5, 1),
  byIntensity: Int32Array.of(2, 3, 0, 4, 1),
  keyposes: Int32Array.of(2, 3),
} as unknown as KeyposeResult;

test('the current keypose, its rank and its neighbours', () => {
  expect(whySubject(result, 0, null)).toEqual({
    candidate: 2,
    keypose: 0,
    rank: 1,
    stronger: null,
    weaker: 3,
  });
  expect(whySubject(result, 1, null)).toMatchObject({
    candidate: 3,
    rank: 2,
    stronger: 2,
    weaker: 0,
  });
});

test('a candidate that was gone to', () => {
  expect(whySubject(result, 1, 0)).toMatchObject({
    candidate: 0,
    keypose: null,
    rank: 3,
    stronger: 3,
  });
});

test('zero intensity is the end', () => {
  expect(whySubject(result, 1, 4)).toMatchObject({ rank: 4, stronger: 0, weaker: null });
});

test('no keypose, no subject; no order, no rank', () => {
  expect(whySubject(result, null, null)).toBeNull();
  const unordered = { ...result, byIntensity: new Int32Array() };
  expect(whySubject(unordered, 0, null)).toMatchObject({
    rank: null,
    stronger: null,
    weaker: null,
  });
});
