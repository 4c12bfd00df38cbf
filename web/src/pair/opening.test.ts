import { describe, expect, it } from 'vitest';
import { startOfA } from './opening';

const clip = (id: number, keyposes: number[], leadingRestFrames = 0) => ({
  id,
  keyposes: Int32Array.from(keyposes),
  frames: 100,
  frameTimeS: 0.1,
  performer: { leadingRestFrames },
});

const before = (clips: ReturnType<typeof clip>[], frames: number[]) => ({
  clips,
  frameOf: (place: number) => frames[place],
  timeOf: (place: number) => frames[place] / 10 + 0.01,
});

const none = before([], []);

describe('the pair opens', () => {
  it('at the first keypose of A', () => {
    expect(startOfA(clip(7, [12, 30]), none, 0)).toBeCloseTo(1.2);
  });

  it('after the rest before the motion where there is no keypose', () => {
    expect(startOfA(clip(7, [], 4), none, 0)).toBeCloseTo(0.4);
    expect(startOfA(clip(7, [], 100), none, 0)).toBeCloseTo(9.9);
  });

  it('where the study was led', () => {
    expect(startOfA(clip(7, [12, 30]), none, 25)).toBeCloseTo(2.5);
  });

  it('where B was, when B comes to be A', () => {
    expect(startOfA(clip(8, [12]), before([clip(7, [3]), clip(8, [12])], [3, 40]), 0)).toBe(4.01);
  });

  it('at the keypose that is found while nobody has touched the time', () => {
    const [unread, read] = [clip(7, [], 1), clip(7, [12], 1)];
    expect(startOfA(read, before([unread], [1]), 0)).toBeCloseTo(1.2);
    expect(startOfA(read, before([unread], [2]), 0)).toBeCloseTo(0.21);
  });
});
