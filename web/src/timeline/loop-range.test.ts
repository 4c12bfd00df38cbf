import { describe, expect, it } from 'vitest';
import { endAfterKey, withEnd } from './loop-range';

describe('withEnd', () => {
  const range = { a: 10, b: 20 };

  it('moves one end and leaves the other', () => {
    expect(withEnd(range, 'a', 4.4, 100)).toEqual({ a: 4, b: 20 });
    expect(withEnd(range, 'b', 500, 100)).toEqual({ a: 10, b: 100 });
  });

  it('changes the ends about where one passes the other, and never makes them one', () => {
    expect(withEnd(range, 'a', 30, 100)).toEqual({ a: 20, b: 30 });
    expect(withEnd(range, 'b', 10, 100)).toBeNull();
  });
});

describe('endAfterKey', () => {
  it('goes by frames, by tenths of a second with Shift, and to the ends', () => {
    expect(endAfterKey('ArrowLeft', false, 10, 100, 12)).toBe(9);
    expect(endAfterKey('ArrowRight', true, 10, 100, 12)).toBe(22);
    expect(endAfterKey('ArrowRight', true, 10, 100, 0)).toBe(11);
    expect(endAfterKey('Home', false, 10, 100, 12)).toBe(0);
    expect(endAfterKey('End', false, 10, 100, 12)).toBe(100);
    expect(endAfterKey('k', false, 10, 100, 12)).toBeNull();
  });
});
