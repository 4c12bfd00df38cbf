import { describe, expect, it } from 'vitest';
import { place, placed } from './placement';

/** A body at (2, 1) that faces +Z, its left hand at +X (up-frame.ts), and one step ahead of it. */
const body = Float32Array.of(2, 1, 1, 2.5, 1.4, 1, 2, 0.1, 2);
const from = { x: 2, z: 1, yawRad: 0 };

const moved = (to: typeof from, mirrored: boolean): number[] => {
  const joints = body.slice();
  place(joints, placed(from, to, mirrored));
  return [...joints].map((value) => Math.round(value * 1e5) / 1e5 + 0);
};

describe('placed', () => {
  it('moves and turns a body to where another stands', () => {
    const [px, , pz, hx, hy, hz, sx, , sz] = moved({ x: 0, z: 0, yawRad: Math.PI / 2 }, false);
    expect([px, pz]).toEqual([0, 0]);
    // Now it faces +X, so that its left is −Z.
    expect([sx, sz]).toEqual([1, 0]);
    expect([hx, hy, hz]).toEqual([0, expect.closeTo(1.4, 5), -0.5]);
  });

  it('mirrors about the direction that the body faces: left and right change places', () => {
    const [px, , pz, hx, , hz, sx, , sz] = moved({ x: 2, z: 1, yawRad: 0 }, true);
    expect([px, pz]).toEqual([2, 1]);
    expect([hx, hz]).toEqual([1.5, 1]);
    expect([sx, sz]).toEqual([2, 2]);
  });

  it('mirrors and turns at once', () => {
    const [, , , hx, , hz, sx, , sz] = moved({ x: 0, z: 0, yawRad: Math.PI / 2 }, true);
    expect([sx, sz]).toEqual([1, 0]);
    expect([hx, hz]).toEqual([0, 0.5]);
  });
});
