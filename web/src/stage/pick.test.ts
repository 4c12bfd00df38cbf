import { describe, expect, it } from 'vitest';
import { jointOfHit, pickCone, type Ray } from './pick';

/** An upright cone, one that lies, and one behind them. */
const cones = [
  [0, 0, 0, 0.1, 0, 1, 0, 0.05],
  [0.5, 0, 0, 0.02, 1.5, 0, 0, 0.02],
  [0, 0, -3, 0.5, 0, 1, -3, 0.5],
].flat();
const from = (x: number, y: number): Ray => ({ origin: [x, y, 5], direction: [0, 0, -1] });
const pick = (ray: Ray) => pickCone(cones, 8, 0, 3, ray);

describe('pickCone', () => {
  it('finds the nearest cone on the ray and where on it', () => {
    const hit = pick(from(0, 0.25));
    expect(hit?.cone).toBe(0);
    expect(hit?.along).toBeCloseTo(0.25, 9);
    expect(hit?.distance).toBeCloseTo(5 - 0.0875, 6);
    expect(pick(from(0.3, 0.5))?.cone).toBe(2);
  });

  it('meets a thin bone a little beside it, and not farther away', () => {
    expect(pick(from(1, 0.03))?.cone).toBe(1);
    expect(pick(from(1, 0.04))).toBeNull();
  });

  it('meets the round ends, and nothing behind the eye', () => {
    expect(pick(from(0, -0.09))).toMatchObject({ cone: 0, along: 0 });
    expect(pick({ origin: [0, 0.5, 5], direction: [0, 0, 1] })).toBeNull();
  });

  it('along its own axis, and of no length, a cone is a ball', () => {
    const axis = pick({ origin: [0, 5, 0], direction: [0, -1, 0] });
    expect(axis?.cone).toBe(0);
    const ball = pickCone([0, 0, 0, 0.1, 0, 0, 0, 0.1], 8, 0, 1, from(0.05, 0));
    expect(ball?.cone).toBe(0);
    expect(pickCone([NaN, 0, 0, 0.1, 0, 0, 0, 0.1], 8, 0, 1, from(0, 0))).toBeNull();
  });
});

describe('jointOfHit', () => {
  const point = (joint: number) => ({ from: joint, to: joint, mix: 0 });
  const bone = {
    start: point(3),
    end: point(4),
    startRadius: 1,
    endRadius: 1,
    side: 'left',
    limb: 0,
  } as const;

  it('is the joint at the nearer end', () => {
    expect([jointOfHit(bone, 0.4), jointOfHit(bone, 0.6)]).toEqual([3, 4]);
  });

  it('of an end between two joints, the nearer of these', () => {
    const riding = { ...bone, end: { from: 4, to: 9, mix: 0.7 } };
    expect(jointOfHit(riding, 1)).toBe(9);
  });
});
