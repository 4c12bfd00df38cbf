import { describe, expect, it } from 'vitest';
import { Axis } from './axis';
import { reduceToColumns } from './speed-columns';

describe('reduceToColumns', () => {
  it('keeps the extremes of crowded frames', () => {
    const values = Float64Array.from({ length: 10_000 }, () => 1);
    values[5000] = 9;
    values[7000] = 0;
    const columns = reduceToColumns(values, 0, new Axis(128, 9999));
    expect(Math.max(...columns.maximum)).toBe(9);
    expect(Math.min(...columns.minimum)).toBe(0);
    expect(columns.maximum.length).toBe(101);
  });

  it('goes straight from frame to frame where frames are far apart', () => {
    const columns = reduceToColumns(Float64Array.of(0, 1), 0, new Axis(128, 1));
    expect(columns.maximum[50]).toBeCloseTo(0.505, 10);
    expect(columns.minimum[50]).toBeCloseTo(0.495, 10);
  });
});
