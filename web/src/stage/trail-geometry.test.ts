import { describe, expect, it } from 'vitest';
import { type TrailPath, TUBE_CORNERS, tubes } from './trail-geometry';

function path(points: readonly (readonly [number, number, number])[], side = 0): TrailPath {
  return {
    points: Float32Array.from(points.flat()),
    times: Float32Array.from(points, (_, i) => i / Math.max(1, points.length - 1)),
    side,
  };
}

const line = [
  [0, 0, 0],
  [0, 1, 0],
  [0, 2, 0],
] as const;

describe('tubes', () => {
  it('lie around the path at the radius, with its times and side', () => {
    const { positions, times, sides } = tubes([path(line, 1)], 0.1);
    expect(positions).toHaveLength(3 * TUBE_CORNERS * 3);
    for (let i = 0; i < positions.length; i += 3)
      expect(Math.hypot(positions[i], positions[i + 2])).toBeCloseTo(0.1, 6);
    expect(times[TUBE_CORNERS]).toBe(0.5);
    expect(new Set(sides)).toEqual(new Set([1]));
  });

  it('of several paths are one mesh whose triangles face outward', () => {
    const { positions, normals, index } = tubes(
      [
        path(line),
        path([
          [5, 0, 0],
          [6, 0, 0],
        ]),
      ],
      0.1,
    );
    expect(index).toHaveLength((2 + 1) * TUBE_CORNERS * 6);
    expect(Math.max(...index)).toBe(5 * TUBE_CORNERS - 1);
    const at = (array: Float32Array, i: number): number[] => [...array.subarray(i * 3, i * 3 + 3)];
    for (let i = 0; i < index.length; i += 3) {
      const [a, b, c] = [0, 1, 2].map((k) => at(positions, index[i + k]));
      const u = b.map((value, k) => value - a[k]);
      const v = c.map((value, k) => value - a[k]);
      const out = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
      const normal = at(normals, index[i]);
      expect(out[0] * normal[0] + out[1] * normal[1] + out[2] * normal[2]).toBeGreaterThan(0);
    }
  });

  it('do not twist where the path turns', () => {
    const arc = Array.from({ length: 40 }, (_, i) => {
      const angle = (i / 39) * Math.PI * 2;
      return [Math.cos(angle), Math.sin(angle), i / 20] as const;
    });
    const { normals } = tubes([path(arc)], 0.01);
    for (let ring = 1; ring < 40; ring++) {
      const dot = [0, 1, 2]
        .map(
          (k) => normals[ring * TUBE_CORNERS * 3 + k] * normals[(ring - 1) * TUBE_CORNERS * 3 + k],
        )
        .reduce((a, b) => a + b);
      expect(dot).toBeGreaterThan(0.9);
    }
  });

  it('leave out points that rest or are nowhere, and paths without a length', () => {
    const held = path([
      [0, 0, 0],
      [0, 0, 0.0001],
      [NaN, 0, 0],
      [0, 0, 1],
    ]);
    expect(tubes([held], 0.1).times).toHaveLength(2 * TUBE_CORNERS);
    expect(
      tubes(
        [
          path([
            [1, 1, 1],
            [1, 1, 1],
          ]),
        ],
        0.1,
      ).index,
    ).toHaveLength(0);
    expect(tubes([], 0.1).index).toHaveLength(0);
  });
});
