/** The store's comparison, cut, labels and order in; the one set that matrix, tree, names and map draw out. */
import type { Clip } from '../app/clips';
import type { MatrixOrder } from '../app/compare-store';
import type { Comparison, Cut } from '../engine/comparison-types';
import type { ClipId } from '../engine/types';
import { clipNames } from './clip-words';
import { orderItems, type Ordering } from './item-order';
import { treeNodes, type TreeNodes } from './tree-layout';

export interface Scene extends Ordering {
  readonly comparison: Comparison;
  readonly cut: Cut | null;
  readonly kind: MatrixOrder;
  readonly count: number;
  /** File names without their ending, told apart, by item. */
  readonly names: readonly string[];
  /** Every label of the library once; its place gives it colour and shape. */
  readonly labels: readonly string[];
  /** −1: no label. */
  readonly labelOfItem: Int32Array;
  readonly itemOfClip: ReadonlyMap<ClipId, number>;
  readonly nodes: TreeNodes;
}

export interface SceneParts {
  readonly comparison: Comparison;
  readonly cut: Cut | null;
  readonly kind: MatrixOrder;
  readonly clips: readonly Clip[];
  /** What tells namesakes apart. */
  readonly qualifiers: ReadonlyMap<ClipId, string>;
  readonly labels: ReadonlyMap<ClipId, string | null>;
  readonly labelNames: readonly string[];
}

/** A cut of an older comparison says nothing of this one. */
const fittingCut = ({ cut, comparison }: SceneParts): Cut | null =>
  cut?.clusterOfItem.length === comparison.clips.length ? cut : null;

export function sceneOf(parts: SceneParts): Scene {
  const { comparison, kind, clips } = parts;
  const { clips: ids, tree } = comparison;
  const nameOf = clipNames(parts.qualifiers);
  const names = Array.from(ids, (id) => nameOf(clips[id]));
  const labelOf = Array.from(ids, (id) => parts.labels.get(id) ?? null);
  const labels = parts.labelNames;
  const indexOf = new Map(labels.map((label, index) => [label, index]));
  const labelOfItem = Int32Array.from(
    labelOf,
    (label) => (label === null ? undefined : indexOf.get(label)) ?? -1,
  );
  const cut = fittingCut(parts);
  const clusterOfItem = cut?.clusterOfItem ?? null;
  const items = { leaves: tree.leaves, names, labels, labelOfItem, clusterOfItem };
  const ordering = orderItems(kind, items);
  return {
    ...ordering,
    comparison,
    cut,
    kind,
    count: ids.length,
    names,
    labels,
    labelOfItem,
    itemOfClip: new Map(Array.from(ids, (id, item) => [id, item])),
    nodes: treeNodes(tree, ordering.positionOfItem, labelOfItem),
  };
}

/** The cluster of an item, from 1 in the order of the tree. */
export const clusterNumber = ({ cut }: Scene, item: number): number =>
  (cut?.clusterOfItem[item] ?? 0) + 1;
