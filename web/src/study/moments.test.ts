import { describe, expect, test } from 'vitest';
import { ghostMoments, trailFrames } from './moments';

const keyposes = Int32Array.of(60, 100, 340, 400);
const clip = { firstFrame: 1, lastFrame: 720, frameTimeS: 1 / 60 };

describe('ghostMoments', () => {
  test('are the neighbouring keyposes, not frames at a fixed distance', () => {
    expect(ghostMoments(keyposes, 2)).toEqual([
      { number: 2, frame: 100 },
      { number: 4, frame: 400 },
    ]);
  });

  test('the first and the last have one neighbour, none has none', () => {
    expect(ghostMoments(keyposes, 0)).toEqual([{ number: 2, frame: 100 }]);
    expect(ghostMoments(keyposes, 3)).toEqual([{ number: 3, frame: 340 }]);
    expect(ghostMoments(Int32Array.of(5), 0)).toEqual([]);
    expect(ghostMoments(keyposes, null)).toEqual([]);
  });
});

describe('trailFrames', () => {
  test('go from the previous keypose to the next', () => {
    const frames = trailFrames(keyposes, 1, clip);
    expect([frames[0], frames[frames.length - 1]]).toEqual([60, 340]);
    expect(frames).toHaveLength(281);
    expect(frames).toContain(100);
  });

  test('at a high rate only as many as a smooth curve needs, the keypose itself among them', () => {
    const frames = trailFrames(keyposes, 1, { ...clip, frameTimeS: 1 / 120 });
    expect(frames).toHaveLength(141);
    const odd = trailFrames(Int32Array.of(10, 21, 40), 1, { ...clip, frameTimeS: 1 / 120 });
    expect([...odd].slice(4, 9)).toEqual([18, 20, 21, 22, 24]);
  });

  test('of a gap of an hour at most 600, in ascending order', () => {
    const frames = trailFrames(Int32Array.of(0, 7, 216_000), 1, { ...clip, lastFrame: 216_000 });
    expect(frames.length).toBeLessThanOrEqual(600);
    expect(frames).toContain(7);
    expect([...frames]).toEqual([...frames].sort((a, b) => a - b));
    expect(frames[frames.length - 1]).toBe(216_000);
  });

  test('where there is no keypose on a side, two seconds, within the motion', () => {
    const first = trailFrames(keyposes, 0, clip);
    expect([first[0], first[first.length - 1]]).toEqual([1, 100]);
    const last = trailFrames(keyposes, 3, clip);
    expect([last[0], last[last.length - 1]]).toEqual([340, 520]);
  });

  test('a keypose alone, or none', () => {
    expect(trailFrames(Int32Array.of(5), 0, { ...clip, firstFrame: 5, lastFrame: 5 })).toEqual(
      Int32Array.of(5),
    );
    expect(trailFrames(keyposes, null, clip)).toHaveLength(0);
  });
});
