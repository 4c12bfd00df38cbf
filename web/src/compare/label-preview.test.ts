import { expect, test } from 'vitest';
import { testClip } from '../app/test-clips';
import { labelPreview } from './label-preview';

const clips = ['05_01', '05_02', '07_01', 'walk'].map((name, id) => testClip(id, `${name}.bvh`));

test('one example of each label, then of those that do not match', () => {
  const { matched, unmatched, labels, examples } = labelPreview('{label}_*', clips);
  expect([matched, unmatched, labels]).toEqual([3, 1, 2]);
  expect(examples.map(({ name, label }) => [name, label])).toEqual([
    ['05_01.bvh', '05'],
    ['07_01.bvh', '07'],
    ['walk.bvh', null],
  ]);
});

test('a pattern with a fault says so and shows nothing', () => {
  const { fault, matched, examples } = labelPreview('*_01', clips);
  expect(fault).toBe('no-label');
  expect(matched).toBe(0);
  expect(examples).toEqual([]);
});

test('a few examples are enough', () => {
  const many = [...Array(3000).keys()].map((id) => testClip(id, `${id}_x.bvh`));
  expect(labelPreview('{label}_*', many).examples).toHaveLength(5);
  expect(labelPreview('{label}-*', many).examples).toHaveLength(2);
});
