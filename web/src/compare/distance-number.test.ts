import { describe, expect, it } from 'vitest';
import { createFormat } from '../app/format';
import { distanceNumber } from './distance-number';

describe('a distance', () => {
  const format = createFormat('en');

  it.each([
    [0.0156, '0.0156'],
    [0.03094, '0.0309'],
    [1.25, '1.2500'],
    [0.0009994, '0.00100'],
    [0.00047, '0.00047'],
    [0.000031, '0.000031'],
    [0.0000000312, '3.1×10⁻⁸'],
    [0.00000997, '1.0×10⁻⁵'],
  ])('of %f is written as %s', (distance, text) => {
    expect(distanceNumber(format, distance)).toBe(text);
  });

  it('is 0 where only rounding is left', () => {
    expect(distanceNumber(format, 0)).toBe('0');
    expect(distanceNumber(format, 3e-12)).toBe('0');
  });
});
