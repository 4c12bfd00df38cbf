import { expect, test } from 'vitest';
import { fitting, spread } from './spread';

test('places that are far enough apart stay', () => {
  expect(spread([100, 200, 400], [80, 60, 90], 10, 0, 500)).toEqual([100, 200, 400]);
});

test('close ones part by their widths and stay within', () => {
  expect(spread([480, 490, 495], [40, 60, 20], 10, 0, 500)).toEqual([380, 440, 490]);
  expect(spread([1, 2], [40, 20], 5, 0, 500)).toEqual([20, 55]);
});

test('where there is no room, they share what there is', () => {
  expect(spread([1, 2, 3], [50, 100, 50], 0, 0, 100)).toEqual([12.5, 50, 87.5]);
});

test('none and one', () => {
  expect(spread([], [], 5, 0, 100)).toEqual([]);
  expect(spread([90], [40], 5, 0, 100)).toEqual([80]);
});

test('as many fit as have room with the gaps between them', () => {
  expect(fitting([50, 30, 40], 10, 140)).toBe(3);
  expect(fitting([50, 30, 40], 10, 139)).toBe(2);
  expect(fitting([50], 10, 49)).toBe(0);
});
