/**
 * A tree, the order of its leaves and the axis of the matrix in; where every branch runs out. Nodes
 * count as in the tree: leaves first, then the merges.
 */
import type { Dendrogram } from '../engine/comparison-types';
import type { MatrixAxis } from './matrix-axis';

export interface TreeNodes {
  readonly items: number;
  /** Positions that a node spans. */
  readonly first: Int32Array;
  readonly last: Int32Array;
  readonly height: Float64Array;
  /** The one label of all its leaves; −1: several, or none. */
  readonly label: Int32Array;
}

export const childrenOf = (tree: Dendrogram, items: number, node: number): [number, number] => [
  tree.left[node - items],
  tree.right[node - items],
];

export function treeNodes(
  tree: Dendrogram,
  positionOfItem: Int32Array,
  labelOfItem: Int32Array,
): TreeNodes {
  const items = positionOfItem.length;
  const count = items + tree.heights.length;
  const nodes = {
    items,
    first: new Int32Array(count),
    last: new Int32Array(count),
    height: new Float64Array(count),
    label: new Int32Array(count),
  };
  nodes.first.set(positionOfItem);
  nodes.last.set(positionOfItem);
  nodes.label.set(labelOfItem);
  for (let node = items; node < count; node += 1) {
    const [a, b] = childrenOf(tree, items, node);
    nodes.first[node] = Math.min(nodes.first[a], nodes.first[b]);
    nodes.last[node] = Math.max(nodes.last[a], nodes.last[b]);
    nodes.height[node] = tree.heights[node - items];
    nodes.label[node] = nodes.label[a] === nodes.label[b] ? nodes.label[a] : -1;
  }
  return nodes;
}

/** The pixel on the axis at which each node hangs: half way between its children. */
export function nodeMiddles(tree: Dendrogram, nodes: TreeNodes, axis: MatrixAxis): Float64Array {
  const middles = new Float64Array(nodes.first.length);
  for (let node = 0; node < middles.length; node += 1) {
    if (node < nodes.items) middles[node] = axis.middle(nodes.first[node]);
    else {
      const [a, b] = childrenOf(tree, nodes.items, node);
      middles[node] = (middles[a] + middles[b]) / 2;
    }
  }
  return middles;
}

/** Heights across the tree: the root left, the leaves right, on a square-root scale. */
export class HeightScale {
  constructor(
    private readonly left: number,
    private readonly right: number,
    private readonly highest: number,
  ) {}

  x(height: number): number {
    const part = this.highest > 0 ? Math.sqrt(Math.max(0, height) / this.highest) : 0;
    return this.right - Math.min(1, part) * (this.right - this.left);
  }

  height(x: number): number {
    const part = (this.right - x) / (this.right - this.left);
    return Math.min(1, Math.max(0, part)) ** 2 * this.highest;
  }
}

/** How many clusters a cut at a height leaves; the heights ascend. */
export function clustersAt(heights: Float64Array, height: number): number {
  let [low, high] = [0, heights.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (heights[middle] > height) high = middle;
    else low = middle + 1;
  }
  return heights.length - low + 1;
}

export interface Branch {
  readonly child: number;
  readonly parentX: number;
  readonly parentY: number;
  readonly x: number;
  readonly y: number;
}

export interface TreeView {
  readonly tree: Dendrogram;
  readonly nodes: TreeNodes;
  readonly middles: Float64Array;
  readonly axis: MatrixAxis;
  readonly scale: HeightScale;
  /** The part of the axis in sight. */
  readonly top: number;
  readonly bottom: number;
}

/** Below this many pixels a part of the tree is one line. */
const leastPx = 1;

/** Tells every branch in sight, from the root on; what is narrower than a pixel ends in one line. */
export function visitBranches(view: TreeView, visit: (branch: Branch) => void): void {
  const { tree, nodes, middles, axis, scale } = view;
  const stack = nodes.height.length > 0 ? [nodes.height.length - 1] : [];
  for (let node = stack.pop(); node !== undefined; node = stack.pop()) {
    if (node < nodes.items) continue;
    const parentX = scale.x(nodes.height[node]);
    for (const child of childrenOf(tree, nodes.items, node)) {
      const from = axis.start(nodes.first[child]);
      const to = axis.start(nodes.last[child]) + axis.cell;
      const [y, parentY] = [middles[child], middles[node]];
      if (Math.max(to, parentY) < view.top || Math.min(from, parentY) > view.bottom) continue;
      const narrow = to - from < leastPx;
      visit({ child, parentX, parentY, x: narrow ? scale.x(0) : scale.x(nodes.height[child]), y });
      if (!narrow) stack.push(child);
    }
  }
}
