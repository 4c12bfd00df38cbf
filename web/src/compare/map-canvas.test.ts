import { expect, test } from 'vitest';
import { hullPathOf } from './map-canvas';

test('a hull goes once around its corners', () => {
  const path = hullPathOf([
    [0, 0],
    [10, 0],
    [0, 10],
  ]);
  expect(path).toBe('M0.0 0.0L10.0 0.0L0.0 10.0z');
});

test('one place, of one clip or of several that are alike, has a dot that is drawn', () => {
  expect(hullPathOf([[3, 4]])).toBe('M3.0 4.0h.01');
  expect(
    hullPathOf([
      [3, 4],
      [3, 4],
    ]),
  ).toBe('M3.0 4.0h.01');
});
