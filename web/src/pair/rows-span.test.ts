import { describe, expect, it } from 'vitest';
import { alignedByPaths, alignedByStart } from './alignment';
import { followedRows, groundOf, openedRows, pannedRows, zoomedRows } from './rows-span';

/** 10 s, and 4 s of slower frames. */
const clips = [
  { frames: 1001, frameTimeS: 0.01 },
  { frames: 101, frameTimeS: 0.04 },
];
const ground = groundOf(clips);
/** B passes in 4 s what A passes in 10. */
const warped = alignedByPaths(clips, [null, { pathA: [0, 1000], pathB: [0, 100] }]);
const zoomedIn = { lengthS: 2, firstS: [5, 2] } as const;

describe('zooming the rows', () => {
  it('keeps a moment of A and its like of B in their places', () => {
    const span = zoomedRows(null, ground, 5, [5, 2]);
    expect(span?.lengthS).toBeCloseTo(2);
    expect(span?.firstS[0]).toBeCloseTo(4);
    expect(span?.firstS[1]).toBeCloseTo(1.6);
  });

  it('ends with all of both', () => {
    expect(zoomedRows(zoomedIn, ground, 0.2, [5, 2])).toBeNull();
    expect(zoomedRows(zoomedIn, ground, 0.1, [5, 2])).toBeNull();
  });

  it('shows twenty frames of the quicker clip at least', () => {
    expect(zoomedRows(null, ground, 1e6, [5, 2])?.lengthS).toBeCloseTo(0.2);
  });
});

describe('panning the rows', () => {
  it('takes the other clip along as the two run together', () => {
    const right = pannedRows(zoomedIn, ground, 0, 1, warped);
    expect(right?.firstS[0]).toBeCloseTo(6);
    expect(right?.firstS[1]).toBeCloseTo(2.4);
    const left = pannedRows(right, ground, 1, -0.4, warped);
    expect(left?.firstS[0]).toBeCloseTo(5);
    expect(left?.firstS[1]).toBeCloseTo(2);
  });

  it('stops at the ends', () => {
    expect(pannedRows(zoomedIn, ground, 0, 100, alignedByStart(clips))?.firstS[0]).toBeCloseTo(8);
    expect(pannedRows(zoomedIn, ground, 0, -100, alignedByStart(clips))?.firstS[0]).toBeCloseTo(0);
  });

  it('does nothing where all is shown', () => {
    expect(pannedRows(null, ground, 0, 1, warped)).toBeNull();
  });
});

describe('opening a part of the rows', () => {
  it('shows the moments of both, in the middle', () => {
    const span = openedRows(ground, [4, 1], [6, 2]);
    expect(span?.lengthS).toBeCloseTo(2.6);
    expect(span?.firstS[0]).toBeCloseTo(3.7);
    expect(span?.firstS[1]).toBeCloseTo(0.2);
  });
});

describe('the rows follow the time', () => {
  it('not while it is in view', () => {
    const move = { beforeS: [5.5, 2.5], timeS: [6, 3], playing: true } as const;
    expect(followedRows(zoomedIn, ground, move)).toBe(zoomedIn);
  });

  it('both to the next page as soon as one has left its view', () => {
    const move = { beforeS: [6.99, 2.5], timeS: [7.01, 2.6], playing: true } as const;
    const span = followedRows(zoomedIn, ground, move);
    expect(span?.firstS[0]).toBeCloseTo(7.01 - 0.16);
    expect(span?.firstS[1]).toBeCloseTo(2.6 - 0.16);
  });

  it('each just so far that a key’s moment is in view', () => {
    const move = { beforeS: [5.5, 2.5], timeS: [4, 2.5], playing: false } as const;
    const span = followedRows(zoomedIn, ground, move);
    expect(span?.firstS[0]).toBeCloseTo(4 - 0.16);
    expect(span?.firstS[1]).toBeCloseTo(2);
  });
});
