/** Which rows are folded in; where each row of the timeline lies out: pure geometry. */

import type { FoldableRow } from '../app/store';

export type RowName = 'pins' | 'ruler' | FoldableRow | 'overview';

export interface Row {
  /** Pixels from the timeline's upper edge. */
  readonly top: number;
  readonly height: number;
  readonly folded: boolean;
}

export interface RowLayout extends Readonly<Record<RowName, Row>> {
  /** Where the rows of the span end and the overview begins. */
  readonly spanHeight: number;
  readonly height: number;
}

/** From top to bottom; the order is fixed. */
const HEIGHTS: readonly (readonly [RowName, number])[] = [
  ['pins', 24],
  ['ruler', 22],
  ['speed', 58],
  ['scales', 72],
  ['intensity', 48],
  ['overview', 22],
];
export const FOLDED_HEIGHT = 22;
/** A clip without keyposes says why in the place of its first row; the others are left out. */
const ABSENT: ReadonlySet<RowName> = new Set<RowName>(['scales', 'intensity']);

export const foldableRows: readonly FoldableRow[] = ['speed', 'scales', 'intensity'];

export function layoutRows(folded: ReadonlySet<string>, analysed: boolean): RowLayout {
  let top = 0;
  const rows = HEIGHTS.map(([name, full]) => {
    const isFolded = analysed && foldableRows.some((row) => row === name && folded.has(row));
    const absent = !analysed && ABSENT.has(name);
    const row = { top, height: absent ? 0 : isFolded ? FOLDED_HEIGHT : full, folded: isFolded };
    top += row.height;
    return [name, row] as const;
  });
  const layout = Object.fromEntries(rows) as Record<RowName, Row>;
  return { ...layout, spanHeight: layout.overview.top, height: top };
}

/** The row at a height; null below the last. */
export function rowAt(rows: RowLayout, y: number): RowName | null {
  const name = HEIGHTS.find(
    ([row]) => y >= rows[row].top && y < rows[row].top + rows[row].height,
  )?.[0];
  return name ?? null;
}
