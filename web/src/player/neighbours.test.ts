import { describe, expect, it } from 'vitest';
import { nearestIndex, nextAfter, previousBefore } from './neighbours';

const frames = Int32Array.of(10, 20, 31);

describe('nextAfter and previousBefore', () => {
  it('are strict and do not wrap', () => {
    expect(nextAfter(frames, 9)).toBe(10);
    expect(nextAfter(frames, 10)).toBe(20);
    expect(nextAfter(frames, 31)).toBeNull();
    expect(previousBefore(frames, 31)).toBe(20);
    expect(previousBefore(frames, 32)).toBe(31);
    expect(previousBefore(frames, 10)).toBeNull();
  });

  it('find nothing in nothing', () => {
    expect(nextAfter([], 3)).toBeNull();
    expect(previousBefore([], 3)).toBeNull();
    expect(nearestIndex([], 3)).toBeNull();
  });
});

describe('nearestIndex', () => {
  it('takes the earlier on a tie', () => {
    expect(nearestIndex(frames, 15)).toBe(0);
    expect(nearestIndex(frames, 16)).toBe(1);
    expect(nearestIndex(frames, 25)).toBe(1);
    expect(nearestIndex(frames, 26)).toBe(2);
    expect(nearestIndex(frames, -5)).toBe(0);
    expect(nearestIndex(frames, 500)).toBe(2);
  });
});
