import { describe, expect, it } from 'vitest';
import { alignedAt, alignedByPaths, alignedByStart } from './alignment';

const a = { frames: 101, frameTimeS: 0.01 };
const b = { frames: 61, frameTimeS: 0.05 };

describe('alignedByStart', () => {
  it('shows every clip at its own rate and lasts as long as the longest', () => {
    const start = alignedByStart([a, b]);
    expect(start.durationS).toBeCloseTo(3, 12);
    expect([0.4, 2.5].map((timeS) => start.timeOf(0, timeS))).toEqual([0.4, 1]);
    expect(start.timeOf(1, 2.5)).toBeCloseTo(2.5, 12);
    expect(start.pairTimeOf(1, 2.5)).toBeCloseTo(2.5, 12);
  });
});

describe('alignedAt', () => {
  it('lets the moments given come at once; who begins later waits', () => {
    const keypose = alignedAt([a, b], [0.2, 1.2]);
    const then = keypose.pairTimeOf(0, 0.2);
    expect(keypose.timeOf(1, then)).toBeCloseTo(1.2, 12);
    expect(keypose.timeOf(0, 0.5)).toBe(0);
    expect(keypose.durationS).toBeCloseTo(3, 12);
    expect(alignedAt([a, b], [0.9, 0.1]).durationS).toBeCloseTo(3.8, 12);
  });
});

describe('alignedByPaths', () => {
  // A waits at frame 50 while B runs from frame 20 to 40.
  const steps = [0, 25, 50, 50, 50, 75, 100];
  const path = { pathA: steps, pathB: [0, 10, 20, 30, 40, 50, 60] };

  it('keeps both on the path, the mean of their times as the time of the pair', () => {
    const warped = alignedByPaths([a, b], [null, path]);
    expect(warped.durationS).toBeCloseTo((1 + 3) / 2, 12);
    expect(warped.timeOf(1, warped.pairTimeOf(0, 0.25))).toBeCloseTo(0.5, 12);
    expect(warped.timeOf(0, warped.pairTimeOf(1, 2.5))).toBeCloseTo(0.75, 12);
    const waiting = [1.1, 1.5, 1.9].map((timeS) => warped.timeOf(0, warped.pairTimeOf(1, timeS)));
    for (const timeS of waiting) expect(timeS).toBeCloseTo(0.5, 12);
  });

  it('is met in the middle where a clip waits', () => {
    const warped = alignedByPaths([a, b], [null, path]);
    expect(warped.timeOf(1, warped.pairTimeOf(0, 0.5))).toBeCloseTo(1.5, 12);
  });

  it('leads further clips along their own paths from A', () => {
    const c = { frames: 11, frameTimeS: 0.1 };
    const other = { pathA: [0, 50, 50, 100], pathB: [0, 2, 4, 10] };
    const warped = alignedByPaths([a, b, c], [null, path, other]);
    expect(warped.timeOf(2, warped.pairTimeOf(0, 0.25))).toBeCloseTo(0.15, 12);
    expect(warped.timeOf(2, warped.pairTimeOf(0, 0.75))).toBeCloseTo(0.65, 12);
  });

  it('begins at once while there is no path yet', () => {
    expect(alignedByPaths([a, b], [null, null]).timeOf(1, 0.7)).toBeCloseTo(0.7, 12);
  });
});
