import { describe, expect, it } from 'vitest';
import { Axis } from './axis';
import { Extremes } from './extremes';
import { reduceToColumns } from './speed-columns';

const seriesOf = (values: Float64Array): Extremes => {
  const series = new Extremes(values);
  series.build(values.length);
  return series;
};

describe('reduceToColumns', () => {
  it('keeps the extremes of crowded frames', () => {
    const values = Float64Array.from({ length: 10_000 }, () => 1);
    values[5000] = 9;
    values[7000] = 0;
    const columns = reduceToColumns(seriesOf(values), 0, new Axis(128, 9999));
    expect(Math.max(...columns.maximum)).toBe(9);
    expect(Math.min(...columns.minimum)).toBe(0);
    expect(columns.maximum.length).toBe(101);
  });

  it('goes straight from frame to frame where frames are far apart', () => {
    const columns = reduceToColumns(seriesOf(Float64Array.of(0, 1)), 0, new Axis(128, 1));
    expect(columns.maximum[50]).toBeCloseTo(0.505, 10);
    expect(columns.minimum[50]).toBeCloseTo(0.495, 10);
  });

  it('has the columns of the axis alone, however long the series', () => {
    const series = seriesOf(Float64Array.from({ length: 10_000 }, (_, n) => n));
    const columns = reduceToColumns(series, 0, new Axis(128, 9999, { first: 5000, last: 5100 }));
    expect(columns.firstX).toBe(0);
    expect(columns.maximum.length).toBe(129);
    expect(columns.maximum[10]).toBeCloseTo(5000.5, 9);
  });

  it('leaves a gap where the series has not begun or has ended', () => {
    const series = seriesOf(new Float64Array(50));
    const columns = reduceToColumns(series, 25, new Axis(128, 100));
    expect(columns.firstX).toBe(35);
    expect(columns.maximum.length).toBe(50);
    const beyond = new Axis(128, 1000, { first: 500, last: 600 });
    expect(reduceToColumns(series, 25, beyond).maximum.length).toBe(0);
    expect(reduceToColumns(seriesOf(new Float64Array()), 0, beyond).maximum.length).toBe(0);
  });
});
