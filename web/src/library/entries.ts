/**
 * The clips of the library in their order, their labels, what is folded in; its rows from top to bottom
 * out, heads of groups among them, with where each begins.
 */
import type { Clip } from '../app/clips';
import type { Labels } from '../app/labels';
import type { ClipId } from '../engine/types';
import { rowHeightPx } from './row';

export const groupHeightPx = 28;

export interface GroupEntry {
  readonly kind: 'group';
  /** null: of the clips without one. */
  readonly label: string | null;
  readonly count: number;
  readonly folded: boolean;
}

export interface ClipEntry {
  readonly kind: 'clip';
  readonly clip: Clip;
  /** Among all clips that are listed, folded ones too. */
  readonly index: number;
}

export type LibraryEntry = GroupEntry | ClipEntry;

export interface LibraryLayout {
  readonly entries: readonly LibraryEntry[];
  /** One more than entries: the last is the height of all. */
  readonly tops: Float64Array;
}

export interface LayoutSources {
  /** In the order of their labels where they are grouped. */
  readonly rows: readonly Clip[];
  readonly labels: Labels;
  readonly grouped: boolean;
  readonly folded: ReadonlySet<string | null>;
}

const labelOf = (labels: Labels, clip: Clip | undefined): string | null =>
  clip === undefined ? null : (labels.get(clip.id) ?? null);

function entriesOf({ rows, labels, grouped, folded }: LayoutSources): LibraryEntry[] {
  const clipEntry = (clip: Clip, index: number): ClipEntry => ({ kind: 'clip', clip, index });
  if (!grouped) return rows.map(clipEntry);
  const entries: LibraryEntry[] = [];
  for (let first = 0, end = 0; first < rows.length; first = end) {
    const label = labelOf(labels, rows[first]);
    while (end < rows.length && labelOf(labels, rows[end]) === label) end++;
    const isFolded = folded.has(label);
    entries.push({ kind: 'group', label, count: end - first, folded: isFolded });
    if (isFolded) continue;
    for (let index = first; index < end; index++) entries.push(clipEntry(rows[index], index));
  }
  return entries;
}

export function libraryLayout(sources: LayoutSources): LibraryLayout {
  const entries = entriesOf(sources);
  const tops = new Float64Array(entries.length + 1);
  entries.forEach(({ kind }, index) => {
    tops[index + 1] = tops[index] + (kind === 'group' ? groupHeightPx : rowHeightPx);
  });
  return { entries, tops };
}

export const heightOf = ({ entries, tops }: LibraryLayout): number => tops[entries.length] ?? 0;

export const placeOfClip = ({ entries }: LibraryLayout, id: ClipId | null): number =>
  entries.findIndex((entry) => entry.kind === 'clip' && entry.clip.id === id);

export const placeOfGroup = ({ entries }: LibraryLayout, label: string | null): number =>
  entries.findIndex((entry) => entry.kind === 'group' && entry.label === label);

/** The clips of the rows between two places, both among them, whichever comes first. */
export function clipsBetween({ entries }: LibraryLayout, from: number, to: number): ClipId[] {
  return entries
    .slice(Math.max(0, Math.min(from, to)), Math.max(from, to) + 1)
    .flatMap((entry) => (entry.kind === 'clip' ? [entry.clip.id] : []));
}
