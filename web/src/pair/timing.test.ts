import { describe, expect, it } from 'vitest';
import { tempoOf, timingOf } from './timing';

const speed = { speed: Float64Array.of(1, 2, 6) };

describe('timingOf', () => {
  it('counts keyposes and takes the mean time between them and the mean speed', () => {
    const { keyposes, betweenS, meanSpeed } = timingOf(Int32Array.of(10, 30, 70), speed, 0.01);
    expect(betweenS).toBeCloseTo(0.3, 12);
    expect([keyposes, meanSpeed]).toEqual([3, 3]);
  });

  it('has nothing between fewer than two, and no speed without an analysis', () => {
    expect(timingOf(Int32Array.of(10), null, 0.01)).toEqual({
      keyposes: 1,
      betweenS: null,
      meanSpeed: null,
    });
  });
});

describe('tempoOf', () => {
  const every = (betweenS: number | null) => ({ keyposes: 2, betweenS, meanSpeed: 1 });

  it('tells whose keyposes come faster', () => {
    expect(tempoOf(every(1), every(1.5))).toEqual({ kind: 'faster', who: 'a', times: 1.5 });
    expect(tempoOf(every(2), every(1))).toMatchObject({ who: 'b', times: 2 });
    expect(tempoOf(every(1), every(1.04)).kind).toBe('same');
    expect(tempoOf(every(1), every(null)).kind).toBe('unknown');
  });
});
