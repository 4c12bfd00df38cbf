import { describe, expect, it } from 'vitest';
import type { Warping } from '../engine/comparison-types';
import { AHEAD_MIDDLE, aheadOutline } from './ahead';
import { alignedAt, alignedByPaths, alignedByStart } from './alignment';
import { differenceShades } from './difference';
import { keyposeLines, matchingLines } from './ribbon';
import { axesOf, clipAt, partRow, rows, ROWS_HEIGHT } from './rows-layout';

const a = { frames: 101, frameTimeS: 0.01 };
const b = { frames: 61, frameTimeS: 0.05 };

/** Starts and ends of the curves of a path. */
const ends = (path: string): number[][] =>
  [...path.matchAll(/M([\d.-]+) \S+?C\S+ \S+ \S+ \S+ ([\d.-]+) /g)].map((match) =>
    match.slice(1).map(Number),
  );

describe('rows', () => {
  it('follow each other, B’s the mirror image of A’s', () => {
    expect([rows.stripA, rows.pinsA, rows.speedA].map(({ height }) => height)).toEqual([
      74, 20, 34,
    ]);
    expect(rows.speedB.top).toBe(rows.ribbon.top + 64);
    expect(partRow(4).top + partRow(4).height).toBeLessThan(ROWS_HEIGHT);
    expect([0, rows.ribbon.top + 10, rows.ribbon.top + 50, ROWS_HEIGHT].map(clipAt)).toEqual([
      0, 0, 1, 1,
    ]);
  });

  it('have a second as wide in both clips', () => {
    const [axisA, axisB] = axesOf([a, b], 1028);
    expect(axisA.x(100) - axisA.x(0)).toBeCloseTo(1000 / 3, 6);
    expect(axisB.x(60) - axisB.x(0)).toBeCloseTo(1000, 6);
  });
});

describe('the ribbon', () => {
  const [axisA, axisB] = axesOf([a, b], 1028);
  const [clipA, clipB] = [
    { ...a, axis: axisA },
    { ...b, axis: axisB },
  ];

  it('has upright lines while both run from the start', () => {
    for (const [from, to] of ends(matchingLines(alignedByStart([a, b]), clipA, clipB))) {
      expect(to).toBeCloseTo(from, 6);
      expect(from).toBeLessThanOrEqual(axisA.x(100) + 0.1);
    }
  });

  it('leans by as much as the keyposes lie apart', () => {
    const lines = ends(matchingLines(alignedAt([a, b], [0.2, 1.2]), clipA, clipB));
    for (const [from, to] of lines) expect(to - from).toBeCloseTo(1000 / 3, 0);
  });

  it('leads A’s keyposes along the path', () => {
    const path = { pathA: [0, 50, 100], pathB: [0, 20, 60] };
    const warped = alignedByPaths([a, b], [null, path]);
    const [[from, to]] = ends(keyposeLines(warped, Int32Array.of(50), clipA, clipB));
    expect([from, to]).toEqual([expect.closeTo(axisA.x(50), 0), expect.closeTo(axisB.x(20), 0)]);
  });
});

const warping: Warping = {
  distance: 0.1,
  pathA: Int32Array.of(0, 1, 2),
  pathB: Int32Array.of(0, 30, 60),
  ahead: Float64Array.of(0, 0.1, -0.05),
  partDistances: Float32Array.of(0, 0, 0, 0, 0, 1, 2, 3, 4, 8, 4, 4, 4, 4, 4),
  fullColour: 4,
};

describe('who is ahead', () => {
  it('is A above the line, B below it', () => {
    const { a: above, b: below, most } = aheadOutline(warping, axesOf([a, b], 1028)[1]);
    expect(most).toBe(0.1);
    const heights = (path: string): number[] =>
      [...path.matchAll(/ ([\d.]+)/g)].map((match) => Number(match[1]) - AHEAD_MIDDLE);
    expect(Math.min(...heights(above))).toBeLessThan(-10);
    expect(Math.max(...heights(above))).toBe(0);
    expect(Math.max(...heights(below))).toBeGreaterThan(5);
  });
});

describe('the difference', () => {
  it('lasts from frame to frame, full at the colour’s end', () => {
    const axis = axesOf([a, b], 1028)[1];
    const { left, columns, shades } = differenceShades(warping, axis);
    expect(left).toBe(10);
    const at = (part: number, frame: number): number =>
      shades[part * columns + Math.round(axis.x(frame)) - left];
    expect([at(0, 0), at(0, 29), at(0, 31), at(1, 59), at(4, 31), at(0, 60)]).toEqual([
      0, 0, 0.25, 0.5, 1, 1,
    ]);
  });
});
