import { expect, test } from 'vitest';
import { orderItems, type Orderable } from './item-order';

const items: Orderable = {
  leaves: Int32Array.of(3, 1, 0, 2),
  names: ['b_2', 'b_10', 'a', 'c'],
  labels: ['walk', 'dance'],
  labelOfItem: Int32Array.of(0, 1, -1, 0),
  clusterOfItem: Int32Array.of(1, 0, 1, 0),
};

test('the order of the tree has a gap where the cut falls', () => {
  const { order, groups, positionOfItem } = orderItems('tree', items);
  expect([...order]).toEqual([3, 1, 0, 2]);
  expect([...groups]).toEqual([0, 0, 1, 1]);
  expect([...positionOfItem]).toEqual([2, 1, 3, 0]);
});

test('by label the labels stand by name, each in the order of the tree, unlabelled last', () => {
  const { order, groups } = orderItems('label', items);
  expect([...order]).toEqual([1, 3, 0, 2]);
  expect([...groups]).toEqual([1, 0, 0, -1]);
});

test('by name numbers count as numbers, and there are no gaps', () => {
  const { order, groups } = orderItems('name', items);
  expect([...order]).toEqual([2, 0, 1, 3]);
  expect(new Set(groups).size).toBe(1);
});
