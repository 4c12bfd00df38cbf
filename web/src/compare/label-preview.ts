/** A pattern as it is being written and the clips in; what it would label out. */
import { labelInName, parsePattern, patternFault, type PatternFault } from '../app/label-pattern';
import type { ClipId, ClipSource } from '../engine/types';

export interface LabelExample {
  readonly id: ClipId;
  readonly name: string;
  readonly label: string | null;
}

export interface LabelPreview {
  readonly fault: PatternFault | null;
  readonly matched: number;
  readonly unmatched: number;
  /** Different labels. */
  readonly labels: number;
  /** The first of some labels, then some that do not match. */
  readonly examples: readonly LabelExample[];
}

const mostLabelled = 5;
const mostUnlabelled = 2;

interface Named {
  readonly id: ClipId;
  readonly source: Pick<ClipSource, 'name'>;
}

export function labelPreview(text: string, clips: readonly Named[]): LabelPreview {
  const pattern = parsePattern(text);
  const all = clips.map(({ id, source: { name } }) => ({
    id,
    name,
    label: pattern && labelInName(pattern, name),
  }));
  const unlabelled = all.filter(({ label }) => label === null);
  const firsts = new Map<string, LabelExample>();
  for (const one of all)
    if (one.label !== null && !firsts.has(one.label)) firsts.set(one.label, one);
  const labelled = [...firsts.values()].slice(0, mostLabelled);
  return {
    fault: patternFault(text),
    matched: all.length - unlabelled.length,
    unmatched: unlabelled.length,
    labels: firsts.size,
    examples: [...labelled, ...unlabelled.slice(0, pattern ? mostUnlabelled : 0)],
  };
}
