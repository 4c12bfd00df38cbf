import { expect, test } from 'vitest';
import { filterClips, sortClips } from './order';
import { testClip, testResult } from './test-clips';

const clips = [
  testClip(0, '05_10.bvh', { result: testResult(300, 2) }),
  testClip(1, '05_9.bvh', { result: testResult(100, 9) }, 'Trial B'),
  testClip(2, '花笠踊り.bvh'),
  testClip(3, 'Walk.bvh', { result: testResult(200, 9) }),
];
const labels = new Map([[3, 'gait']]);
const ids = (list: readonly { id: number }[]): number[] => list.map(({ id }) => id);

test('names are sorted as people count', () => {
  expect(ids(sortClips(clips, { key: 'name', descending: false }))).toEqual([1, 0, 3, 2]);
});

test('lengths and keyposes are sorted; clips without come last either way', () => {
  expect(ids(sortClips(clips, { key: 'length', descending: false }))).toEqual([1, 3, 0, 2]);
  expect(ids(sortClips(clips, { key: 'length', descending: true }))).toEqual([0, 3, 1, 2]);
  expect(ids(sortClips(clips, { key: 'keyposes', descending: true }))).toEqual([1, 3, 0, 2]);
});

test('the order of arrival can be turned round', () => {
  expect(ids(sortClips(clips, { key: 'arrival', descending: true }))).toEqual([3, 2, 1, 0]);
});

test('a filter wants every word, in folder, name or label, in any width and case', () => {
  expect(ids(filterClips(clips, 'trial 05', labels))).toEqual([1]);
  expect(ids(filterClips(clips, 'ＷＡＬＫ', labels))).toEqual([3]);
  expect(ids(filterClips(clips, '笠', labels))).toEqual([2]);
  expect(ids(filterClips(clips, 'GAIT', labels))).toEqual([3]);
  expect(filterClips(clips, '  ', labels)).toBe(clips);
});
