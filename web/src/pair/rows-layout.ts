/** The rows of the pair page, from top to bottom, and the axes of its clips: pure geometry. */
import { bodyParts } from '../engine/types';
import { Axis } from '../timeline/axis';
import type { ClipLength } from './alignment';
import { groundOf, wholeRows, type RowsSpan } from './rows-span';

export interface RowPlace {
  readonly top: number;
  readonly height: number;
}

const PART_HEIGHT = 13;
const PARTS_AIR = 7;

const heights = {
  stripA: 74,
  pinsA: 20,
  speedA: 34,
  ribbon: 64,
  speedB: 34,
  pinsB: 20,
  stripB: 74,
  ahead: 48,
  parts: bodyParts.length * PART_HEIGHT + 2 * PARTS_AIR,
};

export type PairRow = keyof typeof heights;

export const rows = ((): Readonly<Record<PairRow, RowPlace>> => {
  let top = 0;
  const places = Object.entries(heights).map(([name, height]) => {
    const place = { top, height };
    top += height;
    return [name, place] as const;
  });
  return Object.fromEntries(places) as Record<PairRow, RowPlace>;
})();

export const ROWS_HEIGHT = rows.parts.top + rows.parts.height;

/** Where the strip of a body part lies. */
export function partRow(part: number): RowPlace {
  return { top: rows.parts.top + PARTS_AIR + part * PART_HEIGHT, height: PART_HEIGHT - 2 };
}

/** A second is as wide in both; where all is shown, the longer one fills the width. */
export function axesOf(
  clips: readonly ClipLength[],
  width: number,
  span: RowsSpan | null = null,
): Axis[] {
  const { lengthS, firstS } = span ?? wholeRows(groundOf(clips));
  return clips.slice(0, 2).map(({ frames, frameTimeS }, clip) => {
    const first = firstS[clip] / frameTimeS;
    return new Axis(width, frames - 1, { first, last: first + lengthS / frameTimeS });
  });
}

/** Where the ribbon's ticks are, the ruler of a clip. */
const RULER_HEIGHT = 14;

/** Whose ruler lies at a height of the rows: there a drag makes a loop. */
export function rulerAt(y: number): 0 | 1 | null {
  const { top, height } = rows.ribbon;
  if (y >= top && y < top + RULER_HEIGHT) return 0;
  return y >= top + height - RULER_HEIGHT && y < top + height ? 1 : null;
}

/** Which clip's time a height of the rows speaks of: 0 A, 1 B. */
export function clipAt(y: number): 0 | 1 {
  return y < rows.ribbon.top + rows.ribbon.height / 2 ? 0 : 1;
}
