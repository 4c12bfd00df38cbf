import { describe, expect, it } from 'vitest';
import type { UpAxis } from '../engine/types';
import { toScene } from './up-frame';

const UP: Record<UpAxis, readonly [number, number, number]> = {
  '+X': [1, 0, 0],
  '-X': [-1, 0, 0],
  '+Y': [0, 1, 0],
  '-Y': [0, -1, 0],
  '+Z': [0, 0, 1],
  '-Z': [0, 0, -1],
};

function columns(up: UpAxis): Float32Array {
  const out = new Float32Array(9);
  toScene([1, 0, 0, 0, 1, 0, 0, 0, 1], { up, groundHeight: 0, bodyHeight: 1 }, out);
  return out;
}

describe('toScene', () => {
  it.each(Object.keys(UP) as UpAxis[])('turns %s up by a rotation, without a mirror', (up) => {
    const out = new Float32Array(3);
    toScene(UP[up], { up, groundHeight: 0, bodyHeight: 1 }, out);
    expect([...out].map((value) => value + 0)).toEqual([0, 1, 0]);
    const [a, b, c, d, e, f, g, h, i] = columns(up);
    expect(a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)).toBe(1);
  });

  it('puts the ground at 0 and measures in body heights', () => {
    const out = new Float32Array(3);
    toScene([2, 3, 7], { up: '+Z', groundHeight: 1, bodyHeight: 2 }, out);
    expect([...out]).toEqual([1, 3, -1.5]);
  });
});
