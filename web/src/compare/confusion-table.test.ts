import { expect, test } from 'vitest';
import { ConfusionCounts } from './confusion-table';

const counts = new ConfusionCounts({
  labels: ['dance', 'walk', 'slow'],
  confusion: [
    [0, 0, 4],
    [1, 0, 2],
    [1, 1, 1],
    [1, 2, 1],
    [2, 1, 1],
  ],
});

test('a cell is painted by its part of its row', () => {
  expect(counts.cell(0, 0)).toEqual({ count: 4, kind: 'strong', paint: 90 });
  expect(counts.cell(1, 1)).toEqual({ count: 1, kind: 'right', paint: 38 });
});

test('what is off the diagonal is wrong; nothing is nothing', () => {
  expect(counts.cell(1, 0).kind).toBe('wrong');
  expect(counts.cell(0, 1)).toEqual({ count: 0, kind: 'none', paint: 0 });
});
