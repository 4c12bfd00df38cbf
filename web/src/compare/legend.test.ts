import { expect, it } from 'vitest';
import { legendDigits } from './legend';

it.each([
  [0, 1],
  [120, 1],
  [8.1, 2],
  [0.313, 3],
  [0.0809, 3],
  [0.000312, 5],
])('a largest distance of %f is written with %i digits', (maximum, digits) => {
  expect(legendDigits(maximum)).toBe(digits);
});
