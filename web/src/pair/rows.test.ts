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

  it('has lines where A or B is in view, in the same places wherever that is', () => {
    const aligned = alignedByStart([a, b]);
    const zoomedTo = (firstS: number) => {
      const axes = axesOf([a, b], 1028, { lengthS: 0.2, firstS: [firstS, firstS] });
      const [x, y] = [a, b].map((clip, i) => ({ ...clip, axis: axes[i] }));
      const lines = ends(matchingLines(aligned, x, y));
      return lines.map(([from]) => axes[0].placeAt(from));
    };
    const [early, later] = [zoomedTo(0.4), zoomedTo(0.45)];
    expect(early.length).toBeGreaterThan(60);
    expect(early.length).toBeLessThan(70);
    const shared = later.filter((frame) => frame < 60);
    expect(shared.length).toBeGreaterThan(40);
    for (const frame of shared)
      expect(Math.min(...early.map((other) => Math.abs(other - frame)))).toBeLessThan(0.01);
  });

  it('draws one line for keyposes that are too close to be told apart', () => {
    const frames = Int32Array.from({ length: 101 }, (_, frame) => frame);
    const axes = axesOf([a, b], 128);
    const [x, y] = [a, b].map((clip, i) => ({ ...clip, axis: axes[i] }));
    const lines = ends(keyposeLines(alignedByStart([a, b]), frames, x, y));
    expect(lines.length).toBe(6);
  });

  it('stays light where one clip is an hour and the other some seconds', () => {
    const hour = { frames: 432_001, frameTimeS: 1 / 120 };
    const path = { pathA: [0, 432_000], pathB: [0, 100] };
    const frames = Int32Array.from({ length: 2700 }, (_, keypose) => 160 * keypose);
    const warped = alignedByPaths([hour, a], [null, path]);
    for (const span of [null, { lengthS: 3, firstS: [1800, 0] } as const]) {
      const axes = axesOf([hour, a], 1028, span);
      const [x, y] = [hour, a].map((clip, i) => ({ ...clip, axis: axes[i] }));
      expect(ends(keyposeLines(warped, frames, x, y)).length).toBeLessThan(260);
      expect(ends(matchingLines(warped, x, y)).length).toBeLessThan(260);
    }
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
  const axis = axesOf([a, b], 1028)[1];
  const heights = (path: string): number[] =>
    [...path.matchAll(/ ([\d.]+)/g)].map((match) => Number(match[1]) - AHEAD_MIDDLE);

  it('is A above the line, B below it', () => {
    const { a: above, b: below, scale } = aheadOutline(warping, axis);
    expect(scale).toBe(0.1);
    expect(Math.min(...heights(above))).toBe(-20);
    expect(Math.max(...heights(above))).toBe(0);
    expect(Math.max(...heights(below))).toBeCloseTo(10);
  });

  it('fills a small part of its row where nobody is ahead by much', () => {
    const small = { ...warping, ahead: Float64Array.of(0, 0.004, -0.001) };
    const { a: above, scale } = aheadOutline(small, axis);
    expect(scale).toBe(0.05);
    expect(Math.min(...heights(above))).toBeCloseTo(-1.6);
  });

  it('is named where the curve leaves room', () => {
    const path = Int32Array.from({ length: 61 }, (_, frame) => frame);
    const leads = (from: number, to: number): Warping => ({
      ...warping,
      pathB: path,
      ahead: Float64Array.from(path, (frame) => (frame >= from && frame < to ? 0.2 : 0)),
    });
    expect(aheadOutline(leads(20, 30), axis).labelEnds).toEqual([1024, 1024]);
    const [end, other] = aheadOutline(leads(50, 61), axis).labelEnds;
    expect(end).toBeCloseTo(axis.x(50) - 4);
    expect(other).toBe(1024);
    expect(aheadOutline(leads(0, 61), axis).labelEnds[0]).toBe(1024);
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

  it('is told of what is in view alone, from the frame before it on', () => {
    const span = { lengthS: 0.5, firstS: [0, 1.75] } as const;
    const axis = axesOf([a, b], 528, span)[1];
    const { left, columns, shades } = differenceShades(warping, axis);
    expect([left, columns]).toEqual([0, 528]);
    // Frames 35 … 45 of B: what step 1, of frame 30, has.
    expect([shades[0], shades[527], shades[columns]]).toEqual([0.25, 0.25, 0.5]);
    const past = axesOf([a, b], 528, { lengthS: 0.5, firstS: [0, 3.5] })[1];
    expect(differenceShades(warping, past).columns).toBe(0);
  });
});
