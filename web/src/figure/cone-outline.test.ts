import { describe, expect, it } from 'vitest';
import { hullAngles, hullPath } from './cone-outline';

describe('hullAngles', () => {
  it('touches both circles with one straight line', () => {
    const angles = hullAngles(1, 2, 3, 9, 5, 1);
    expect(angles).not.toBeNull();
    const { axis, spread } = angles as { axis: number; spread: number };
    for (const angle of [axis + spread, axis - spread]) {
      const normal = [Math.cos(angle), Math.sin(angle)];
      const along = [9 + normal[0] - (1 + 3 * normal[0]), 5 + normal[1] - (2 + 3 * normal[1])];
      expect(along[0] * normal[0] + along[1] * normal[1]).toBeCloseTo(0, 9);
    }
  });

  it('has none where one circle holds the other', () => {
    expect(hullAngles(0, 0, 5, 1, 1, 1)).toBeNull();
    expect(hullAngles(0, 0, 2, 0, 0, 2)).toBeNull();
  });
});

describe('hullPath', () => {
  it('draws a capsule', () => {
    expect(hullPath(0, 0, 1, 4, 0, 1)).toBe('M0 -1L4 -1A1 1 0 0 1 4 1L0 1A1 1 0 1 1 0 -1Z');
  });

  it('takes the long way round the larger end', () => {
    expect(hullPath(0, 0, 1, 4, 0, 2)).toMatch(/A2 2 0 1 1 .*A1 1 0 0 1 /);
    expect(hullPath(0, 0, 2, 4, 0, 1)).toMatch(/A1 1 0 0 1 .*A2 2 0 1 1 /);
  });

  it('draws the larger circle alone where it holds the other', () => {
    expect(hullPath(0, 0, 5, 1, 1, 1)).toBe('M-5 0A5 5 0 1 1 5 0A5 5 0 1 1 -5 0Z');
    expect(hullPath(1, 1, 1, 0, 0, 5)).toBe(hullPath(0, 0, 5, 1, 1, 1));
  });
});
