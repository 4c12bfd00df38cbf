import { expect, test } from 'vitest';
import { qualifiers } from '../app/names';
import { testClip } from '../app/test-clips';
import { clipNames } from './clip-words';
import { testScene } from './test-scene';

const clips = [
  testClip(0, 'walk.bvh', {}, 'first'),
  testClip(1, 'walk.bvh', {}, 'second'),
  testClip(2, 'run.BVH', {}, 'second'),
  testClip(3, 'jump.bvh'),
];

test('a clip has no ending to its name, and a namesake what tells it apart', () => {
  const nameOf = clipNames(qualifiers(clips));
  expect(clips.map(nameOf)).toEqual(['first walk', 'second walk', 'run', 'jump']);
  expect([nameOf(null), nameOf(undefined)]).toEqual(['', '']);
});

test('it is the name that matrix and map show', () => {
  const scene = testScene({ clips, qualifiers: qualifiers(clips) });
  expect(scene.names).toEqual(clips.map(clipNames(qualifiers(clips))));
});
