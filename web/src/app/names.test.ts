import { expect, test } from 'vitest';
import { qualifiers, splitName } from './names';
import { testClip } from './test-clips';

test('namesakes are told apart by their folder', () => {
  const clips = [
    testClip(0, 'a.bvh', {}, 'one'),
    testClip(1, 'a.bvh', {}, 'two'),
    testClip(2, 'b.bvh'),
  ];
  expect([...qualifiers(clips)]).toEqual([
    [0, 'one'],
    [1, 'two'],
  ]);
});

test('where the folder is the same, a number tells them apart', () => {
  const clips = [
    testClip(0, 'a.bvh'),
    testClip(1, 'a.bvh'),
    testClip(2, 'a.bvh', {}, 'x'),
    testClip(3, 'a.bvh', {}, 'x'),
  ];
  expect([...qualifiers(clips).values()]).toEqual(['(1)', '(2)', 'x (1)', 'x (2)']);
});

test('a split name is the name, and its end stays whole', () => {
  for (const name of ['花笠踊り_第三回_佐藤.bvh', 'a.bvh', '', 'x'.repeat(300), '👩‍👩‍👧.bvh']) {
    expect(splitName(name).join('')).toBe(name);
  }
  expect(splitName('花笠踊り_第三回_佐藤.bvh')).toEqual(['花笠踊り_第三回', '_佐藤.bvh']);
});
