import { describe, expect, it } from 'vitest';
import { Axis } from './axis';
import { clockTime, divisionOf, labelWidth, rulerTicks, type Tick } from './ruler-layout';

const ticksOf = (axis: Axis, frameTimeS: number): Tick[] =>
  rulerTicks(axis, frameTimeS, divisionOf(axis, frameTimeS));

describe('rulerTicks', () => {
  it('labels half seconds where there is room', () => {
    const majors = ticksOf(new Axis(760, 480), 1 / 120).filter(({ size }) => size === 'major');
    expect(majors.map(({ timeS }) => timeS)).toEqual([0, 0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4]);
    expect(majors[1].frame).toBe(60);
  });

  it('never lets labels touch, from a moment to ten hours, at any zoom', () => {
    for (const frames of [2, 30, 400, 4500, 432_000, 4_320_000]) {
      for (const length of [20, 300, 5000, 432_000, frames - 1]) {
        if (length >= frames) continue;
        const axis = new Axis(760, frames - 1, { first: frames - 1 - length, last: frames - 1 });
        const division = divisionOf(axis, 1 / 120);
        const ticks = rulerTicks(axis, 1 / 120, division);
        const majors = ticks.filter(({ size }) => size === 'major');
        const width = labelWidth(axis, 1 / 120, division.digits);
        majors.slice(1).forEach(({ x }, index) => expect(x - majors[index].x >= width).toBe(true));
        expect(ticks.length).toBeLessThan(120);
      }
    }
  });

  it('has a tick for each frame when zoomed in, in step with the frames of the file', () => {
    const axis = new Axis(1000, 5000, { first: 1000.5, last: 1020.5 });
    const ticks = ticksOf(axis, 1 / 30);
    expect(ticks.map(({ frame }) => frame)).toEqual(Array.from({ length: 20 }, (_, n) => 1001 + n));
    const majors = ticks.filter(({ size }) => size === 'major');
    expect(majors.map(({ frame }) => frame % 2)).toEqual(majors.map(() => 0));
    expect(majors[0].x).toBeCloseTo(axis.x(majors[0].frame), 9);
  });

  it('keeps within the clip', () => {
    const ticks = ticksOf(new Axis(760, 100), 1 / 60);
    expect(ticks[0].timeS).toBe(0);
    expect(ticks.at(-1)!.timeS).toBeLessThanOrEqual(100 / 60);
  });
});

describe('clockTime', () => {
  it('goes from seconds to hours', () => {
    expect(clockTime(0.5, 1)).toBe('0.5');
    expect(clockTime(90, 0)).toBe('1:30');
    expect(clockTime(61.25, 2)).toBe('1:01.25');
    expect(clockTime(3725, 0)).toBe('1:02:05');
    expect(clockTime(59.9999, 2)).toBe('1:00.00');
  });
});
