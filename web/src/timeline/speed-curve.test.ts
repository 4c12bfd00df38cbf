import { describe, expect, it } from 'vitest';
import { Axis } from './axis';
import { Extremes } from './extremes';
import { curveOf } from './speed-curve';

const seriesOf = (values: Float64Array): Extremes => {
  const series = new Extremes(values);
  series.build(values.length);
  return series;
};

describe('curveOf', () => {
  it('keeps the extremes of crowded frames', () => {
    const values = Float64Array.from({ length: 10_000 }, () => 1);
    values[5000] = 9;
    values[7000] = 0;
    const curve = curveOf(seriesOf(values), 0, new Axis(128, 9999));
    expect(Math.max(...curve.maximum)).toBe(9);
    expect(Math.min(...curve.minimum)).toBe(0);
    expect(curve.x.length).toBe(101);
  });

  it('leaves no step between columns that hold less than a frame each', () => {
    const values = Float64Array.from({ length: 150 }, (_, n) => n);
    const curve = curveOf(seriesOf(values), 0, new Axis(128, 149));
    for (let column = 1; column < curve.x.length; column++)
      expect(curve.minimum[column]).toBeCloseTo(curve.maximum[column - 1], 9);
  });

  it('goes from frame to frame where frames are far apart', () => {
    const axis = new Axis(128, 10);
    const curve = curveOf(seriesOf(Float64Array.of(0, 1, 4)), 3, axis);
    expect([...curve.x]).toEqual([axis.x(3), axis.x(4), axis.x(5)]);
    expect([...curve.maximum]).toEqual([0, 1, 4]);
  });

  it('has what the axis shows and one frame beyond, however long the series', () => {
    const series = seriesOf(Float64Array.from({ length: 10_000 }, (_, n) => n));
    const near = curveOf(series, 0, new Axis(128, 9999, { first: 5000, last: 5020 }));
    expect([near.maximum[0], near.maximum.at(-1)]).toEqual([4998, 5024]);
    const far = curveOf(series, 0, new Axis(128, 9999, { first: 5000, last: 5500 }));
    expect(far.x.length).toBe(129);
    expect(far.maximum[10]).toBeCloseTo(5002.5, 9);
  });

  it('leaves a gap where the series has not begun or has ended', () => {
    const series = seriesOf(new Float64Array(50));
    const curve = curveOf(series, 25, new Axis(78, 100));
    expect([curve.x[0], curve.x.at(-1)]).toEqual([23, 47]);
    for (const length of [20, 400]) {
      const beyond = new Axis(128, 1000, { first: 500, last: 500 + length });
      expect(curveOf(series, 25, beyond).x.length).toBe(0);
      expect(curveOf(seriesOf(new Float64Array()), 0, beyond).x.length).toBe(0);
    }
  });
});
