/** The rows of the pair page, from top to bottom, and the axes of its clips: pure geometry. */
import { bodyParts } from '../engine/types';
import { Axis } from '../timeline/axis';
import type { ClipLength } from './alignment';

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

/** A second is as wide in all of them; the longest fills the width. */
export function axesOf(clips: readonly ClipLength[], width: number): Axis[] {
  const longestS = Math.max(...clips.map((clip) => (clip.frames - 1) * clip.frameTimeS), 0);
  return clips.map(({ frames, frameTimeS }) => {
    const last = Math.max(longestS / frameTimeS, 1);
    return new Axis(width, Math.max(0, frames - 1), { first: 0, last });
  });
}

/** Which clip's time a height of the rows speaks of: 0 A, 1 B. */
export function clipAt(y: number): 0 | 1 {
  return y < rows.ribbon.top + rows.ribbon.height / 2 ? 0 : 1;
}
