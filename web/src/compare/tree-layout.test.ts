import { expect, test } from 'vitest';
import type { Dendrogram } from '../engine/comparison-types';
import { MatrixAxis } from './matrix-axis';
import {
  HeightScale,
  clustersAt,
  nodeMiddles,
  treeNodes,
  visitBranches,
  type Branch,
} from './tree-layout';

/** ((0 1) (2 3)) at heights 1, 2 and 4. */
const tree: Dendrogram = {
  left: Int32Array.of(0, 2, 4),
  right: Int32Array.of(1, 3, 5),
  heights: Float64Array.of(1, 2, 4),
  sizes: Int32Array.of(2, 2, 4),
  leaves: Int32Array.of(0, 1, 2, 3),
  orderIsOptimal: true,
};
const positions = Int32Array.of(0, 1, 2, 3);
const axis = new MatrixAxis(Int32Array.of(0, 0, 1, 1), { cell: 10, gap: 4 });

test('a branch knows its positions, its height and its label while it is pure', () => {
  const nodes = treeNodes(tree, positions, Int32Array.of(5, 5, 5, 6));
  expect([nodes.first[5], nodes.last[5], nodes.first[6], nodes.last[6]]).toEqual([2, 3, 0, 3]);
  expect([...nodes.label.slice(4)]).toEqual([5, -1, -1]);
  expect([...nodes.height.slice(4)]).toEqual([1, 2, 4]);
});

test('a node hangs half way between its children', () => {
  const nodes = treeNodes(tree, positions, Int32Array.of(0, 0, 0, 0));
  expect([...nodeMiddles(tree, nodes, axis)]).toEqual([5, 15, 29, 39, 10, 34, 22]);
});

test('a cut leaves one cluster more than there are merges above it', () => {
  expect([0.5, 1, 1.5, 3, 5].map((height) => clustersAt(tree.heights, height))).toEqual([
    4, 3, 3, 2, 1,
  ]);
});

test('the scale of heights goes both ways', () => {
  const scale = new HeightScale(20, 120, 4);
  expect([scale.x(0), scale.x(1), scale.x(4)]).toEqual([120, 70, 20]);
  expect(scale.height(70)).toBeCloseTo(1);
  expect(scale.height(500)).toBe(0);
});

function branches(top: number, bottom: number, cell = 10): Branch[] {
  const nodes = treeNodes(tree, positions, Int32Array.of(0, 0, 0, 0));
  const small = new MatrixAxis(Int32Array.of(0, 0, 1, 1), { cell, gap: 4 });
  const found: Branch[] = [];
  const middles = nodeMiddles(tree, nodes, small);
  const scale = new HeightScale(0, 100, 4);
  const view = { tree, nodes, middles, axis: small, scale, top, bottom };
  visitBranches(view, (branch) => found.push(branch));
  return found;
}

test('every branch in sight is told, and none beside it', () => {
  expect(branches(0, 50)).toHaveLength(6);
  const upper = branches(0, 19).map(({ child }) => child);
  expect(upper.sort()).toEqual([0, 1, 4]);
});

test('what is narrower than a pixel is one line to the leaves', () => {
  const tiny = branches(0, 50, 0.2);
  expect(tiny.map(({ child, x }) => [child, x])).toEqual([
    [4, 100],
    [5, 100],
  ]);
});
