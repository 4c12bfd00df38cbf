import { describe, expect, it } from 'vitest';
import { FollowPoint } from './follow';
import type { Framing } from './view';

const at = (targetX: number, targetZ: number, distance = 1): Framing => ({
  targetX,
  targetY: 0,
  targetZ,
  distance,
});

describe('FollowPoint', () => {
  it('comes calmly nearer and then arrives', () => {
    const point = new FollowPoint();
    expect(point.step(at(1, 0), 1 / 60, true)).toBe(true);
    expect(point.targetX).toBeGreaterThan(0);
    expect(point.targetX).toBeLessThan(0.2);
    let steps = 0;
    while (point.step(at(1, 0), 1 / 60, true)) steps++;
    expect(point.targetX).toBe(1);
    expect(steps).toBeLessThan(120);
  });

  it('goes equally far in equal time, whatever the frame rate', () => {
    const quick = new FollowPoint();
    const slow = new FollowPoint();
    for (let i = 0; i < 8; i++) quick.step(at(1, -1), 1 / 120, true);
    for (let i = 0; i < 2; i++) slow.step(at(1, -1), 1 / 30, true);
    expect(quick.targetX).toBeCloseTo(slow.targetX, 9);
    expect(quick.targetZ).toBeCloseTo(slow.targetZ, 9);
  });

  it('leaps with a leap in time, and at once with reduced motion', () => {
    const point = new FollowPoint();
    expect(point.step(at(5, 0), 1 / 60, true)).toBe(false);
    expect(point.targetX).toBe(5);
    expect(point.step(at(5.5, 0), 1 / 60, false)).toBe(false);
    expect(point.targetX).toBe(5.5);
  });

  it('goes away calmly from figures that part', () => {
    const point = new FollowPoint();
    expect(point.step(at(0, 0, 3), 1 / 60, true)).toBe(true);
    expect(point.distance).toBeGreaterThan(1);
    expect(point.distance).toBeLessThan(1.5);
    while (point.step(at(0, 0, 3), 1 / 60, true));
    expect(point.distance).toBe(3);
  });
});
