/** The clips of the library in; those that the filter lets through, in the order asked for, out. */
import { isAnalysed, keyposeCount, lengthOf, type Clip } from './clips';
import type { Labels } from './labels';

export type SortKey = 'arrival' | 'name' | 'length' | 'keyposes';

export interface Sort {
  readonly key: SortKey;
  readonly descending: boolean;
}

export const sortKeys: readonly SortKey[] = ['arrival', 'name', 'length', 'keyposes'];

const byName = new Intl.Collator(['en', 'ja'], { numeric: true, sensitivity: 'base' });

/** As people sort names: numbers by their value, case and width apart only at last. */
export const compareText = (a: string, b: string): number => byName.compare(a, b);

const measures: Readonly<Record<'length' | 'keyposes', (clip: Clip) => number | null>> = {
  length: (clip) => (clip.extent ? lengthOf(clip.extent) : null),
  keyposes: (clip) => (isAnalysed(clip) ? keyposeCount(clip) : null),
};

function compareNames(a: Clip, b: Clip): number {
  return (
    byName.compare(a.source.name, b.source.name) || byName.compare(a.source.folder, b.source.folder)
  );
}

/** Clips without a value come last in either direction. */
function compareMeasures(a: number | null, b: number | null, direction: number): number {
  if (a === null || b === null) return Number(a === null) - Number(b === null);
  return direction * (a - b);
}

export function sortClips(clips: readonly Clip[], { key, descending }: Sort): Clip[] {
  const direction = descending ? -1 : 1;
  const compare = (a: Clip, b: Clip): number => {
    if (key === 'arrival') return direction * (a.id - b.id);
    if (key === 'name') return direction * compareNames(a, b) || a.id - b.id;
    return compareMeasures(measures[key](a), measures[key](b), direction) || a.id - b.id;
  };
  return [...clips].sort(compare);
}

/** Clips of one label beside each other, in the order of the labels; those without come last. */
export function groupClips(
  clips: readonly Clip[],
  labels: Labels,
  labelNames: readonly string[],
): readonly Clip[] {
  const groups = new Map<string | null, Clip[]>([...labelNames, null].map((label) => [label, []]));
  for (const clip of clips) groups.get(labels.get(clip.id) ?? null)?.push(clip);
  return [...groups.values()].flat();
}

const plain = (text: string): string => text.normalize('NFKC').toLowerCase();

/** Every word of the filter must stand in the clip's folder, name or label. */
export function filterClips(
  clips: readonly Clip[],
  filter: string,
  labels: Labels,
): readonly Clip[] {
  const words = plain(filter).split(/\s+/).filter(Boolean);
  if (words.length === 0) return clips;
  return clips.filter(({ id, source }) => {
    const text = plain(`${source.folder}/${source.name} ${labels.get(id) ?? ''}`);
    return words.every((word) => text.includes(word));
  });
}
