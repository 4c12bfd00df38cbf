import { expect, test } from 'vitest';
import { spread } from './spread';

test('places that are far enough apart stay', () => {
  expect(spread([100, 200, 400], 90, 0, 500)).toEqual([100, 200, 400]);
});

test('close places part and stay within', () => {
  const places = spread([480, 490, 495], 50, 0, 500);
  expect(places).toEqual([400, 450, 500]);
});

test('where there is no room, they share what there is', () => {
  expect(spread([1, 2, 3], 90, 0, 100)).toEqual([0, 50, 100]);
});
