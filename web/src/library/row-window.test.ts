import { expect, test } from 'vitest';
import { rowWindow, scrollToRow, unevenWindow } from './row-window';

test('of thousands of rows only those in sight and a margin exist', () => {
  const { first, end } = rowWindow(3000, 44, 44_000, 880);
  expect(first).toBe(994);
  expect(end).toBe(1026);
});

test('the window never leaves the list', () => {
  expect(rowWindow(3, 44, 0, 800)).toEqual({ first: 0, end: 3 });
  expect(rowWindow(0, 44, 500, 800)).toEqual({ first: 0, end: 0 });
});

test('a row comes into view with the least movement', () => {
  expect(scrollToRow(5, 44, 0, 800)).toBe(0);
  expect(scrollToRow(30, 44, 0, 800)).toBe(31 * 44 - 800);
  expect(scrollToRow(2, 44, 500, 800)).toBe(88);
});

test('of rows of different heights, too, those in sight and a margin exist', () => {
  const tops = Float64Array.from({ length: 3001 }, (_, n) => 44 * n - 16 * Math.ceil(n / 10));
  const { first, end } = unevenWindow(tops, tops[1000], 880);
  expect(first).toBe(994);
  expect(tops[end - 1]).toBeGreaterThan(tops[1000] + 880);
  expect(end).toBeLessThan(1035);
  expect(unevenWindow(tops, 1e9, 800).end).toBe(3000);
  expect(unevenWindow(Float64Array.of(0), 50, 800)).toEqual({ first: 0, end: 0 });
});
