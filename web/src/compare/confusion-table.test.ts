import { expect, test } from 'vitest';
import { confusionCell } from './confusion-table';

const labels = ['dance', 'walk', 'slow'];
const confusion = Int32Array.from([4, 0, 0, 2, 1, 1, 0, 1, 0]);

test('a cell is painted by its part of its row', () => {
  expect(confusionCell({ confusion, labels }, 0, 0)).toEqual({
    count: 4,
    kind: 'strong',
    paint: 90,
  });
  expect(confusionCell({ confusion, labels }, 1, 1)).toEqual({
    count: 1,
    kind: 'right',
    paint: 38,
  });
});

test('what is off the diagonal is wrong; nothing is nothing', () => {
  expect(confusionCell({ confusion, labels }, 1, 0).kind).toBe('wrong');
  expect(confusionCell({ confusion, labels }, 0, 1)).toEqual({ count: 0, kind: 'none', paint: 0 });
});
