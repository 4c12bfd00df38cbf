/** For tests: a comparison of four clips, ((0 1) (2 3)), and its scene with one label on the first two. */
import { testClip } from '../app/test-clips';
import { usualSettings } from '../app/compare-store';
import type { Comparison, Cut } from '../engine/comparison-types';
import { sceneOf, type Scene, type SceneParts } from './scene';

export const testComparison: Comparison = {
  settings: usualSettings,
  clips: Int32Array.of(0, 1, 2, 3),
  pairs: 6,
  tree: {
    left: Int32Array.of(0, 2, 4),
    right: Int32Array.of(1, 3, 5),
    heights: Float64Array.of(1, 2, 4),
    sizes: Int32Array.of(2, 2, 4),
    leaves: Int32Array.of(2, 3, 0, 1),
    orderIsOptimal: true,
  },
  automaticClusters: 2,
  nearest: Int32Array.of(1, 0, 3, 2),
  nearestDistances: Float64Array.of(1, 1, 2, 2),
  legendMaximum: 3,
  maximum: 4,
  map: Float64Array.of(0, 0, 1, 0, 4, 3, 5, 3),
  spread: 0.9,
};

export const testCut: Cut = {
  clusters: 2,
  clusterOfItem: Int32Array.of(1, 1, 0, 0),
  height: 3,
};

export function testScene(parts: Partial<SceneParts> = {}): Scene {
  return sceneOf({
    comparison: testComparison,
    cut: testCut,
    kind: 'tree',
    clips: ['a.bvh', 'b.bvh', 'c.bvh', 'd.bvh'].map((name, id) => testClip(id, name)),
    qualifiers: new Map(),
    labels: new Map([
      [0, 'walk'],
      [1, 'walk'],
      [2, 'run'],
      [3, null],
    ]),
    labelNames: ['walk', 'run'],
    ...parts,
  });
}
