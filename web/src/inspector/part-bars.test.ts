import { expect, test } from 'vitest';
import { bodyParts } from '../engine/types';
import { barPath, partBars } from './part-bars';

test('rows ascend; what has no value is last', () => {
  const rows = partBars([0, 0, 0, 0, 0, 38, -58, NaN, -33, 28], 1);
  expect(rows.map(({ part, percent }) => [part, percent])).toEqual([
    ['right-arm', -58],
    ['right-leg', -33],
    ['head', 28],
    ['left-arm', 38],
    ['left-leg', null],
  ]);
  expect(rows.map(({ side }) => side)).toEqual(['right', 'right', 'trunk', 'left', 'left']);
});

test('columns are those of the engine', () => {
  expect(partBars([1, 2, 3, 4, 5], 0).map(({ part }) => part)).toEqual([...bodyParts]);
});

test('no values, no rows', () => {
  expect(partBars(new Float64Array(), 0)).toEqual([]);
});

test('bars go left and right of the middle; beyond 100 % they end in a point', () => {
  expect(barPath(-50)).toBe('M75 1.5H43V8.5H75Z');
  expect(barPath(100)).toBe('M75 1.5H139V8.5H75Z');
  expect(barPath(0)).toBe('M75 1.5H75V8.5H75Z');
  expect(barPath(250)).toBe('M75 1.5H141l5 3.5L141 8.5H75Z');
});
