import { describe, expect, it } from 'vitest';
import { Axis } from './axis';
import { labelStepS, rulerTicks } from './ruler-layout';

describe('rulerTicks', () => {
  it('labels half seconds where there is room', () => {
    const axis = new Axis(760, 480);
    const majors = rulerTicks(axis, 1 / 120).filter((tick) => tick.size === 'major');
    expect(majors.map((tick) => tick.timeS)).toEqual([0, 0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4]);
    expect(majors[1].frame).toBe(60);
  });

  it('never lets labels touch, from a moment to ten hours', () => {
    for (const frames of [2, 30, 400, 4500, 432_000, 4_320_000]) {
      const axis = new Axis(760, frames - 1);
      const step = labelStepS(axis, 1 / 120);
      expect(step * 120 * axis.scale >= 82).toBe(true);
      expect(rulerTicks(axis, 1 / 120).length).toBeLessThan(120);
    }
  });
});
