/** Widths of the entries of a legend and its room in; how many of them fit, with the count of the others, out. */

/** After these, colour and shape repeat. */
const mostEntries = 12;
const mostLines = 3;
export const entryGapPx = 12;

function linesOf(widthsPx: readonly number[], roomPx: number): number {
  let [lines, atPx] = [1, 0];
  for (const width of widthsPx) {
    const ownPx = Math.min(width, roomPx);
    const nextPx = atPx === 0 ? ownPx : atPx + entryGapPx + ownPx;
    if (nextPx > roomPx) lines += 1;
    atPx = nextPx > roomPx ? ownPx : nextPx;
  }
  return lines;
}

export interface Entries {
  readonly count: number;
  /** Of the entry at a place, from 0. */
  readonly widthPx: (place: number) => number;
  /** Of the words for so many that are left out; they stand at the end. */
  readonly restPx: (rest: number) => number;
}

/** One at least: an entry that is too wide for the room takes a line of its own. */
export function entriesThatFit({ count, widthPx, restPx }: Entries, roomPx: number): number {
  const most = Math.min(count, mostEntries);
  const widthsPx = Array.from({ length: most }, (_, place) => widthPx(place));
  for (let shown = most; shown > 1; shown -= 1) {
    const rest = shown < count ? [restPx(count - shown)] : [];
    if (linesOf([...widthsPx.slice(0, shown), ...rest], roomPx) <= mostLines) return shown;
  }
  return Math.min(1, count);
}
