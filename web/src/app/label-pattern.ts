/**
 * A pattern of file names in, e.g. `{label}_*`; the label in a name, or what is wrong with the pattern,
 * out. `{label}` stands for one sign or more, `*` for any signs or none, each for as few as the rest
 * allows; all else stands for itself. The same rules as the command line's (docs/formats.md, "Labels").
 */
const placeholder = '{label}';
/** Where a name cannot tell what belongs to the label. */
const touching = [`${placeholder}*`, `*${placeholder}`];
const extension = /\.bvh$/i;

export type PatternFault =
  /** There is no `{label}`. */
  | 'no-label'
  /** `{label}` stands there more than once. */
  | 'many-labels'
  /** A brace that belongs to no `{label}`. */
  | 'brace'
  /** `{label}` and `*` with nothing between them. */
  | 'touching';

export interface LabelPattern {
  /** The texts between what stands for other signs: one more than `wilds`. */
  readonly literals: readonly string[];
  readonly wilds: readonly ('label' | 'any')[];
  /** Whether the pattern itself says how the file's ending reads. */
  readonly withExtension: boolean;
}

export function patternFault(text: string): PatternFault | null {
  const count = text.split(placeholder).length - 1;
  if (/[{}]/.test(text.replaceAll(placeholder, ''))) return 'brace';
  if (count === 0) return 'no-label';
  if (count > 1) return 'many-labels';
  return touching.some((pair) => text.includes(pair)) ? 'touching' : null;
}

/** null: the pattern has a fault. */
export function parsePattern(text: string): LabelPattern | null {
  if (patternFault(text) !== null) return null;
  const wilds = [...text.matchAll(/\{label\}|\*+/g)].map(([sign]) =>
    sign === placeholder ? ('label' as const) : ('any' as const),
  );
  const literals = text.split(/\{label\}|\*+/);
  return { literals, wilds, withExtension: extension.test(text) };
}

/** null: the name does not match. */
export function labelInName(pattern: LabelPattern, fileName: string): string | null {
  const name = pattern.withExtension ? fileName : fileName.replace(extension, '');
  const { literals, wilds } = pattern;
  if (!name.startsWith(literals[0])) return null;
  let from = literals[0].length;
  let label: string | null = null;
  for (const [index, wild] of wilds.entries()) {
    const next = literals[index + 1];
    const isLast = index === wilds.length - 1;
    const least = wild === 'label' ? from + 1 : from;
    const end = isLast ? name.length - next.length : name.indexOf(next, least);
    if (end < least || !name.startsWith(next, end)) return null;
    if (wild === 'label') label = name.slice(from, end);
    from = end + next.length;
  }
  return label;
}
