/** Clips, labels, comparison and cut in; the rows of the table, filtered, sorted and grouped, out. */
import { isAnalysed, keyposeCount, lengthOf, type Clip } from '../app/clips';
import type { Labels } from '../app/labels';
import { qualifiedName } from '../app/names';
import { compareText, filterClips } from '../app/order';
import type { Comparison, Cut } from '../engine/comparison-types';
import type { ClipId } from '../engine/types';

export const columns = [
  'name',
  'label',
  'length',
  'rate',
  'keyposes',
  'cluster',
  'nearest',
  'distance',
] as const;
export type Column = (typeof columns)[number];

/** What the table says of one clip; null: it is not known, or there is none. */
export interface ClipFacts {
  readonly clip: Clip;
  readonly name: string;
  readonly label: string | null;
  readonly length: number | null;
  readonly rate: number | null;
  readonly keyposes: number | null;
  /** From 1, in the order of the tree. */
  readonly cluster: number | null;
  readonly nearest: string | null;
  readonly nearestId: ClipId | null;
  readonly distance: number | null;
  /** It cannot be compared. */
  readonly apart: boolean;
}

export interface FactSources {
  readonly clips: readonly Clip[];
  readonly qualifiers: ReadonlyMap<ClipId, string>;
  readonly labels: Labels;
  readonly comparison: Comparison | null;
  readonly cut: Cut | null;
}

type Compared = Pick<ClipFacts, 'cluster' | 'nearest' | 'nearestId' | 'distance'>;

const notCompared: Compared = { cluster: null, nearest: null, nearestId: null, distance: null };

function comparedBy({ clips, qualifiers, comparison, cut }: FactSources): (id: ClipId) => Compared {
  if (!comparison) return () => notCompared;
  const { clips: ids, nearest, nearestDistances } = comparison;
  const itemOf = new Map(Array.from(ids, (id, item) => [id, item]));
  const nameOf = new Map(
    clips.map(({ id, source }) => [id, qualifiedName(source.name, qualifiers.get(id))]),
  );
  // A cut of an older comparison says nothing of this one.
  const clusters = cut?.clusterOfItem.length === ids.length ? cut.clusterOfItem : null;
  return (id) => {
    const item = itemOf.get(id);
    if (item === undefined) return notCompared;
    const nearestId = ids[nearest[item] ?? -1] ?? null;
    return {
      cluster: clusters ? (clusters[item] ?? 0) + 1 : null,
      nearest: nearestId === null ? null : (nameOf.get(nearestId) ?? null),
      nearestId,
      distance: nearestId === null ? null : (nearestDistances[item] ?? null),
    };
  };
}

/** Of the clips that are present, in their order. */
export function clipFacts(sources: FactSources): readonly ClipFacts[] {
  const compared = comparedBy(sources);
  return sources.clips.map((clip) => {
    const extent = clip.result ?? clip.extent;
    return {
      clip,
      name: qualifiedName(clip.source.name, sources.qualifiers.get(clip.id)),
      label: sources.labels.get(clip.id) ?? null,
      length: extent && lengthOf(extent),
      rate: extent && extent.frameTimeS > 0 ? 1 / extent.frameTimeS : null,
      keyposes: isAnalysed(clip) ? keyposeCount(clip) : null,
      ...compared(clip.id),
      apart: clip.status === 'failed' || clip.incomparable !== null,
    };
  });
}

export interface TableSort {
  readonly column: Column;
  readonly descending: boolean;
}

/** What is not known comes last in either direction. */
function compareFacts(a: ClipFacts, b: ClipFacts, { column, descending }: TableSort): number {
  const [x, y] = [a[column], b[column]];
  if (x === null || y === null) return Number(x === null) - Number(y === null);
  const order =
    typeof x === 'number' && typeof y === 'number' ? x - y : compareText(String(x), String(y));
  return descending ? -order : order;
}

export interface GroupRow {
  readonly kind: 'group';
  /** null: of clips without a label; `apart`: of those that cannot be compared. */
  readonly label: string | null;
  readonly apart: boolean;
  readonly count: number;
}

export interface ClipRow {
  readonly kind: 'clip';
  readonly facts: ClipFacts;
}

export type TableRow = GroupRow | ClipRow;

export interface RowSettings {
  readonly sort: TableSort;
  readonly filter: string;
  readonly grouped: boolean;
  /** Labels in their order. */
  readonly labelNames: readonly string[];
}

function filtered(facts: readonly ClipFacts[], filter: string): readonly ClipFacts[] {
  const labels = new Map(facts.map(({ clip, label }) => [clip.id, label]));
  const clips = facts.map(({ clip }) => clip);
  const kept = filterClips(clips, filter, labels);
  if (kept.length === clips.length) return facts;
  const ids = new Set(kept.map(({ id }) => id));
  return facts.filter(({ clip }) => ids.has(clip.id));
}

function groupsOf(
  facts: readonly ClipFacts[],
  labelNames: readonly string[],
): (readonly [Omit<GroupRow, 'kind' | 'count'>, readonly ClipFacts[]])[] {
  const members = new Map<string | null, ClipFacts[]>();
  for (const fact of facts.filter(({ apart }) => !apart)) {
    const group = members.get(fact.label);
    if (group) group.push(fact);
    else members.set(fact.label, [fact]);
  }
  const byLabel = [...labelNames, null].map(
    (label) => [{ label, apart: false }, members.get(label) ?? []] as const,
  );
  return [...byLabel, [{ label: null, apart: true }, facts.filter(({ apart }) => apart)]];
}

export function tableRows(facts: readonly ClipFacts[], settings: RowSettings): readonly TableRow[] {
  const { sort, filter, grouped, labelNames } = settings;
  const sorted = [...filtered(facts, filter)].sort(
    (a, b) => compareFacts(a, b, sort) || a.clip.id - b.clip.id,
  );
  const row = (fact: ClipFacts): ClipRow => ({ kind: 'clip', facts: fact });
  if (!grouped) return sorted.map(row);
  return groupsOf(sorted, labelNames).flatMap(([group, members]): TableRow[] =>
    members.length > 0
      ? [{ kind: 'group', count: members.length, ...group }, ...members.map(row)]
      : [],
  );
}

/** The clip that a step leads to from the one in focus; group heads are passed over. */
export function stepTo(rows: readonly TableRow[], from: ClipId | null, key: string): number | null {
  const clips = rows.flatMap((row, index) => (row.kind === 'clip' ? [index] : []));
  const at = clips.findIndex((index) => {
    const row = rows[index];
    return row.kind === 'clip' && row.facts.clip.id === from;
  });
  const last = clips.length - 1;
  const next = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: last }[key];
  if (next === undefined || last < 0) return null;
  return clips[Math.max(0, Math.min(last, next))] ?? null;
}
