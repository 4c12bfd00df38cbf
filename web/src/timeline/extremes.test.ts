import { describe, expect, it } from 'vitest';
import { Extremes } from './extremes';

const values = Float64Array.from({ length: 1000 }, (_, n) => Math.sin(n * n));

function extremesOf(extremes: Extremes, from: number, to: number): number[] {
  extremes.start();
  extremes.take(from, to);
  return [extremes.minimum, extremes.maximum];
}

describe('Extremes', () => {
  const runs = [
    [0, 1000],
    [0, 1],
    [63, 65],
    [64, 128],
    [1, 999],
    [500, 500],
    [120, 700],
    [960, 1000],
  ] as const;
  const expected = runs.map(([from, to]) => {
    const run = values.subarray(from, to);
    return [Math.min(...run), Math.max(...run)];
  });

  it('gives the extremes of any run, at every stage of the building', () => {
    const extremes = new Extremes(values);
    for (;;) {
      expect(runs.map(([from, to]) => extremesOf(extremes, from, to))).toEqual(expected);
      if (extremes.isBuilt) break;
      extremes.build(4);
    }
  });

  it('is built after as many steps as it has blocks', () => {
    const extremes = new Extremes(new Float64Array(64 * 10));
    extremes.build(9);
    expect(extremes.isBuilt).toBe(false);
    extremes.build(9);
    expect(extremes.isBuilt).toBe(true);
  });
});
