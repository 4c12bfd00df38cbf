/** Items with their leaves, labels and names in; the order of the matrix and its groups out. */
import type { MatrixOrder } from '../app/compare-store';

export interface Ordering {
  /** The item at each position, from top to bottom and from left to right. */
  readonly order: Int32Array;
  readonly positionOfItem: Int32Array;
  /** Neighbouring positions of other groups have a gap between them. */
  readonly groups: Int32Array;
}

export interface Orderable {
  readonly leaves: Int32Array;
  readonly names: readonly string[];
  readonly labels: readonly string[];
  /** −1: no label. */
  readonly labelOfItem: Int32Array;
  /** null while the cut is not known. */
  readonly clusterOfItem: Int32Array | null;
}

const collator = new Intl.Collator(['en', 'ja'], { numeric: true, sensitivity: 'base' });

export function inverse(order: Int32Array): Int32Array {
  const positions = new Int32Array(order.length);
  order.forEach((item, position) => (positions[item] = position));
  return positions;
}

/** Labels by name, those without one last; in each, the order of the tree. */
function byLabel({ leaves, labels, labelOfItem }: Orderable): Int32Array {
  const place = inverse(leaves);
  const rank = inverse(
    Int32Array.from(labels.keys()).sort((a, b) => collator.compare(labels[a], labels[b])),
  );
  const rankOf = (item: number): number => rank[labelOfItem[item]] ?? labels.length;
  return leaves.slice().sort((a, b) => rankOf(a) - rankOf(b) || place[a] - place[b]);
}

const byName = ({ leaves, names }: Orderable): Int32Array =>
  Int32Array.from(leaves.keys()).sort((a, b) => collator.compare(names[a], names[b]) || a - b);

export function orderItems(kind: MatrixOrder, items: Orderable): Ordering {
  const order = kind === 'tree' ? items.leaves : kind === 'label' ? byLabel(items) : byName(items);
  const groupOf =
    kind === 'tree' ? items.clusterOfItem : kind === 'label' ? items.labelOfItem : null;
  return {
    order,
    positionOfItem: inverse(order),
    groups: order.map((item) => groupOf?.[item] ?? 0),
  };
}
