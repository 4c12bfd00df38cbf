import { expect, test } from 'vitest';
import { entriesThatFit, entryGapPx, type Entries } from './legend-fit';

const entries = (count: number, widthPx: number, restPx = 80): Entries => ({
  count,
  widthPx: () => widthPx,
  restPx: () => restPx,
});

test('all stand there while they fit', () => {
  expect(entriesThatFit(entries(0, 50), 376)).toBe(0);
  expect(entriesThatFit(entries(7, 50), 376)).toBe(7);
  expect(entriesThatFit(entries(12, 50), 376)).toBe(12);
});

test('colours and shapes of twelve differ: no more are told apart', () => {
  expect(entriesThatFit(entries(300, 20), 376)).toBe(12);
});

test('three lines hold what is shown and the count of the others', () => {
  const room = 3 * 100 + 2 * entryGapPx;
  expect(entriesThatFit(entries(9, 100), room)).toBe(9);
  expect(entriesThatFit(entries(10, 100), room)).toBe(8);
  expect(entriesThatFit(entries(300, 100), room)).toBe(8);
  // One pixel less, and two stand in a line.
  expect(entriesThatFit(entries(9, 100), room - 1)).toBe(6);
});

test('the count of the others is measured as it is written', () => {
  const restPx = (rest: number): number => (rest > 290 ? 150 : 100);
  const room = 3 * 100 + 2 * entryGapPx;
  expect(entriesThatFit({ ...entries(300, 100), restPx }, room)).toBe(7);
});

test('names wider than the room take a line each, and one is always there', () => {
  expect(entriesThatFit(entries(3, 900), 376)).toBe(3);
  expect(entriesThatFit(entries(4, 900), 376)).toBe(2);
  expect(entriesThatFit(entries(4, 900, 900), 10)).toBe(2);
  expect(entriesThatFit(entries(1, 900), 10)).toBe(1);
});
