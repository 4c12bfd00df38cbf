// Everything that a comparison says of a set, as plain data. In: an engine and a comparer with workers of any
// kind; files. Out: for each kind of settings what is exported and found. Run by the page and by Node alike.
import type {
  Comparer,
  ComparisonExportKind,
  ComparisonSettings,
} from '../../../web/src/engine/comparison-types';
import type { ClipSource, Engine } from '../../../web/src/engine/types';

export const comparedSettings: readonly ComparisonSettings[] = [
  {
    distance: { measure: 'posture-variation', mirrorAware: false, acrossRigs: false },
    linkage: 'ward',
  },
  {
    distance: { measure: 'posture-variation', mirrorAware: true, acrossRigs: true },
    linkage: 'average',
  },
];

const kinds: readonly ComparisonExportKind[] = [
  'features-csv',
  'features-npy',
  'matrix-csv',
  'matrix-npy',
  'tree-newick',
  'evaluation-csv',
  'evaluation-json',
];

export interface Said {
  /** Whole files: text, or the bytes of .npy in hexadecimal. */
  readonly files: Readonly<Record<ComparisonExportKind, string>>;
  /** Tree, map and what else is told in arrays, as JSON, which holds every bit of a number. */
  readonly found: string;
}

export interface Compared {
  readonly sets: readonly Said[];
  readonly warpings: string;
}

const plain = (value: unknown): string =>
  JSON.stringify(value, (_, part: unknown) =>
    ArrayBuffer.isView(part) ? Array.from(part as unknown as ArrayLike<number>) : part,
  );

async function fileText(blob: Blob, kind: ComparisonExportKind): Promise<string> {
  if (!kind.endsWith('npy')) return blob.text();
  const bytes = new Uint8Array(await blob.arrayBuffer());
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, '0')).join('');
}

async function saidOf(
  comparer: Comparer,
  settings: ComparisonSettings,
  labelOf: (clip: number) => string | null,
): Promise<Said> {
  const comparison = await comparer.compare(settings);
  const clips = [...comparison.clips];
  const labelled = { clusters: comparison.automaticClusters, labels: clips.map(labelOf) };
  const files: Partial<Record<ComparisonExportKind, string>> = {};
  for (const kind of kinds)
    files[kind] = await fileText(await comparer.exportFile(kind, labelled), kind);
  const order = comparison.tree.leaves;
  const whole = { firstRow: 0, rowCount: order.length, firstColumn: 0, columnCount: order.length };
  const [a = 0, b = 0] = clips;
  const found = [
    comparison,
    await comparer.cut(Math.min(5, clips.length)),
    await comparer.picture({ order, ...whole, most: 7 }),
    await comparer.explain(a, b),
    await comparer.neighbours(b, clips.length),
    await comparer.evaluate(labelled),
  ];
  return { files: files as Said['files'], found: plain(found) };
}

/** The first two clips that can be compared are warped too. */
export async function comparedBy(
  engine: Engine,
  comparer: Comparer,
  sources: readonly ClipSource[],
): Promise<Compared> {
  const comparable: number[] = [];
  const items = sources.map((source, id) => ({ id, source }));
  await engine.survey(items, (some) => {
    for (const { id, feature } of some) {
      if (feature !== null) comparable.push(id);
      comparer.setFeature(id, sources[id]?.name ?? '', feature);
    }
  });
  const labelOf = (clip: number): string | null =>
    /^(.+?)[-_].*/.exec(sources[clip]?.name ?? '')?.[1] ?? null;
  const sets: Said[] = [];
  for (const settings of comparedSettings) sets.push(await saidOf(comparer, settings, labelOf));
  const [a = 0, b = 0] = comparable.sort((one, other) => one - other);
  for (const id of [a, b]) await engine.open(id, items[id].source, {}, {});
  const warpings = [
    await comparer.warp(a, b, { band: null, mirrorB: false }),
    await comparer.warp(a, b, { band: 40, mirrorB: true }),
  ];
  return { sets, warpings: plain(warpings) };
}
