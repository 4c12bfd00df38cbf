import { expect, test } from 'vitest';
import { testClip } from '../app/test-clips';
import type { MapPlace } from '../app/compare-store';
import { clipNames } from './clip-words';
import { arrivedSince } from './map-arrivals';
import { clipAt, labelAt, nameAt, spotOf, type Spots } from './map-spots';
import { testScene } from './test-scene';

const arrivals = new Map<number, MapPlace>([
  [2, [9, 9]],
  [4, [1, 2]],
  [5, [3, 4]],
]);
const clips = ['a', 'b', 'c', 'd', 'e', 'f'].map((name, id) => testClip(id, `${name}.bvh`));
const named = clipNames(new Map([[5, 'left']]));
const nameOf = (id: number): string => named(clips[id]);
const labels = new Map([
  [4, 'run'],
  [5, null],
]);

test('what the scene has is not among what has arrived', () => {
  const arrived = arrivedSince(testScene(), arrivals, nameOf, labels);
  expect(arrived).toEqual([
    { clip: 4, place: [1, 2], name: 'e', label: 1 },
    { clip: 5, place: [3, 4], name: 'left f', label: -1 },
  ]);
});

test('items come first, then what has arrived, under the same numbers everywhere', () => {
  const scene = testScene();
  const arrived = arrivedSince(scene, arrivals, nameOf, labels);
  const spots: Spots = { scene, arrived, points: [] };
  const all = [0, 1, 2, 3, 4, 5];
  expect(all.map((spot) => clipAt(spots, spot))).toEqual(all);
  expect(all.map((clip) => spotOf(spots, clip))).toEqual(all);
  expect(all.map((spot) => nameAt(spots, spot))).toEqual(['a', 'b', 'c', 'd', 'e', 'left f']);
  expect(all.map((spot) => labelAt(spots, spot))).toEqual([0, 0, 1, -1, 1, -1]);
  expect(spotOf(spots, 6)).toBeNull();
  expect(spotOf(spots, null)).toBeNull();
  expect(clipAt(spots, 6)).toBeUndefined();
});
