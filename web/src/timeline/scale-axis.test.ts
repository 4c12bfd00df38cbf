import { describe, expect, it } from 'vitest';
import { scaleRangeOf, scaleY } from './scale-axis';

const row = { top: 100, height: 72, folded: false };

describe('scaleRangeOf', () => {
  it('is that of the parameters, although the extraction ended before the coarsest scale', () => {
    const wanted = { finestHz: 8, coarsestHz: 0.2 };
    expect(scaleRangeOf([8, 4, 2], wanted)).toEqual(wanted);
    expect(scaleRangeOf([], wanted)).toEqual(wanted);
  });

  it('holds an older result whole, and goes by the scales where no parameters are known', () => {
    expect(scaleRangeOf([8, 0.2], { finestHz: 4, coarsestHz: 1 })).toEqual({
      finestHz: 8,
      coarsestHz: 0.2,
    });
    expect(scaleRangeOf([8, 2], null)).toEqual({ finestHz: 8, coarsestHz: 2 });
  });
});

describe('scaleY', () => {
  it('goes down from fine to coarse, an octave always as far', () => {
    const range = { finestHz: 8, coarsestHz: 0.5 };
    expect(scaleY(row, 8, range)).toBe(106);
    expect(scaleY(row, 0.5, range)).toBeCloseTo(166, 9);
    expect(scaleY(row, 2, range)).toBeCloseTo(136, 9);
  });

  it('bears a range of one scale', () => {
    expect(scaleY(row, 8, { finestHz: 8, coarsestHz: 8 })).toBe(106);
  });
});
