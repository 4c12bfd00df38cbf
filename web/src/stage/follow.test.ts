import { describe, expect, it } from 'vitest';
import { FollowPoint } from './follow';

describe('FollowPoint', () => {
  it('comes calmly nearer and then arrives', () => {
    const point = new FollowPoint();
    expect(point.step(1, 0, 1 / 60, true)).toBe(true);
    expect(point.x).toBeGreaterThan(0);
    expect(point.x).toBeLessThan(0.2);
    let steps = 0;
    while (point.step(1, 0, 1 / 60, true)) steps++;
    expect(point.x).toBe(1);
    expect(steps).toBeLessThan(120);
  });

  it('goes equally far in equal time, whatever the frame rate', () => {
    const quick = new FollowPoint();
    const slow = new FollowPoint();
    for (let i = 0; i < 8; i++) quick.step(1, -1, 1 / 120, true);
    for (let i = 0; i < 2; i++) slow.step(1, -1, 1 / 30, true);
    expect(quick.x).toBeCloseTo(slow.x, 9);
    expect(quick.z).toBeCloseTo(slow.z, 9);
  });

  it('leaps with a leap in time, and at once with reduced motion', () => {
    const point = new FollowPoint();
    expect(point.step(5, 0, 1 / 60, true)).toBe(false);
    expect(point.x).toBe(5);
    expect(point.step(5.5, 0, 1 / 60, false)).toBe(false);
    expect(point.x).toBe(5.5);
  });
});
