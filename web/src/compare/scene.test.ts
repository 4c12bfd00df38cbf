import { expect, test } from 'vitest';
import { clusterNumber } from './scene';
import { testCut, testScene } from './test-scene';

test('a scene knows names without their ending, labels and the positions of the items', () => {
  const scene = testScene();
  expect(scene.names).toEqual(['a', 'b', 'c', 'd']);
  expect(scene.labels).toEqual(['walk', 'run']);
  expect([...scene.labelOfItem]).toEqual([0, 0, 1, -1]);
  expect([...scene.positionOfItem]).toEqual([2, 3, 0, 1]);
  expect([...scene.groups]).toEqual([0, 0, 1, 1]);
  expect(clusterNumber(scene, 0)).toBe(2);
});

test('the cut of an older comparison is not taken', () => {
  const cut = { ...testCut, clusterOfItem: Int32Array.of(0, 1) };
  expect(testScene({ cut }).cut).toBeNull();
});
