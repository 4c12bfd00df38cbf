/**
 * Where labels come from in; the label of every clip out, and how a label looks. Those given by hand
 * come before; a clip for which nothing is said has none (null).
 */
import { labelShapes, type LabelShape } from '../common/label-shape';
import type { ClipId, ClipSource } from '../engine/types';
import type { LabelRule } from './compare-store';
import { labelInName, parsePattern } from './label-pattern';

export type Labels = ReadonlyMap<ClipId, string | null>;

interface LabelledClip {
  readonly id: ClipId;
  readonly source: Pick<ClipSource, 'name' | 'folder'>;
}

/** The name of the folder that the file lies in. */
const folderLabel = (folder: string): string | null =>
  folder.split('/').filter(Boolean).at(-1) ?? null;

function byRule(rule: LabelRule): (source: LabelledClip['source']) => string | null {
  if (rule.kind === 'folder') return ({ folder }) => folderLabel(folder);
  const pattern = rule.kind === 'pattern' ? parsePattern(rule.pattern) : null;
  return ({ name }) => (pattern ? labelInName(pattern, name) : null);
}

/** What labels that a rule gives are called instead. */
export type LabelRenames = ReadonlyMap<string, string>;

export function labelsOf(
  rule: LabelRule,
  hand: ReadonlyMap<ClipId, string>,
  clips: readonly LabelledClip[],
  renames: LabelRenames = new Map(),
): Labels {
  const found = byRule(rule);
  const named = (label: string | null): string | null =>
    label === null ? null : (renames.get(label) ?? label);
  return new Map(
    clips.map(({ id, source }) => {
      const given = hand.get(id);
      return [id, given === undefined ? named(found(source)) : given || null];
    }),
  );
}

/** Another name for a label, also for clips that come later; labels that were called so go along. */
export function withRename(renames: LabelRenames, from: string, to: string): LabelRenames {
  const moved = [...renames].map(([label, name]) => [label, name === from ? to : name] as const);
  return new Map([...moved, ...(renames.has(from) ? [] : [[from, to] as const])]);
}

/** Every label once, in the order of its first clip: a label keeps its place while clips arrive. */
export function labelNames(labels: Labels): readonly string[] {
  return [...new Set([...labels.values()].filter((label) => label !== null))];
}

export interface LabelStyle {
  /** The token of its colour. */
  readonly colour: `--label-${number}`;
  readonly shape: LabelShape;
  /** Drawn as an outline. */
  readonly open: boolean;
}

/** Of the label at that place of `labelNames`: beyond six, colours and shapes repeat, every other time open. */
export function labelStyle(index: number): LabelStyle {
  const place = index % labelShapes.length;
  return {
    colour: `--label-${place}`,
    shape: labelShapes[place],
    open: Math.floor(index / labelShapes.length) % 2 === 1,
  };
}

/** The first of the labels that look as this one does; −1 stays: no label. */
export const labelLook = (index: number): number =>
  index < 0 ? index : index % (2 * labelShapes.length);

/** The map before where it says the same as the new one, so that nothing is told of no change. */
export function steadyLabels(before: Labels, now: Labels): Labels {
  if (before.size !== now.size) return now;
  for (const [id, label] of now) {
    if (before.get(id) !== label || !before.has(id)) return now;
  }
  return before;
}
