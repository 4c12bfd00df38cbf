import { expect, test } from 'vitest';
import type { PerformerResult } from '../engine/types';
import type { FlatFigure } from '../figure/flat-figure';
import { figureBoxHeight, stripFrames, stripGround, stripScale } from './strip-figures';

const performer = (keyposes: unknown): PerformerResult =>
  ({ keyposes, leadingRestFrames: 10 }) as PerformerResult;
const figure = (fields: Partial<FlatFigure>): FlatFigure => ({
  limbs: [],
  minX: -0.2,
  maxX: 0.2,
  minY: 0,
  maxY: 1.1,
  ...fields,
});

test('the most intense keyposes, in time order', () => {
  const keyposes = {
    candidates: Int32Array.from([5, 20, 40, 60, 80, 100]),
    keyposes: Int32Array.from([0, 1, 2, 4, 5]),
    byIntensity: Int32Array.from([5, 3, 0, 4, 2, 1]),
  };
  expect([...stripFrames({ frames: 120 }, performer(keyposes))]).toEqual([5, 40, 80, 100]);
});

test('frames at even distances where nothing was found', () => {
  expect([...stripFrames({ frames: 111 }, performer(null))]).toEqual([23, 48, 73, 98]);
  expect([...stripFrames({ frames: 1 }, performer(null))]).toEqual([0]);
  expect([...stripFrames({ frames: 0 }, performer(null))]).toEqual([]);
});

test('one scale and one ground for all figures', () => {
  const leap = figure({ maxY: 1.6 });
  expect(stripScale([figure({}), leap])).toBeCloseTo(52 / 1.6);
  expect(stripScale([])).toBe(figureBoxHeight);
  expect(stripGround([figure({}), figure({ minY: -0.1 })], 50)).toBe(49);
});
