import { expect, test } from 'vitest';
import { oldPlaces } from './map-glide';

test('a clip glides from where it stood; a new one stands at its place at once', () => {
  const before = new Map([
    [7, 0],
    [8, 1],
  ]);
  const shown = Float64Array.of(1, 2, 3, 4);
  const from = oldPlaces(Int32Array.of(8, 9), Float64Array.of(10, 20, 30, 40), before, shown);
  expect([...from]).toEqual([3, 4, 30, 40]);
});
