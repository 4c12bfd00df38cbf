/** Where the dot of each candidate stands in the row of intensity, and how large it is: pure geometry. */
import type { Row } from './rows';

const FOOT = 5;
const AIR = 14;
const FOLDED_AIR = 10;
const SMALLEST = 1.4;
const GROWTH = 4.4;
const FOLDED_SIZE = 0.6;
/** The radius of a candidate without intensity. */
export const ZERO_RADIUS = 1.1;

/** Height of an intensity, in pixels from the timeline's upper edge. */
export function intensityY(row: Row, intensity: number, largest: number): number {
  const span = row.height - (row.folded ? FOLDED_AIR : AIR);
  return row.top + row.height - FOOT - (largest > 0 ? intensity / largest : 0) * span;
}

/** Its area, too, grows with the intensity. */
export function intensityRadius(row: Row, intensity: number, largest: number): number {
  const radius = SMALLEST + GROWTH * Math.sqrt(largest > 0 ? intensity / largest : 0);
  return row.folded ? radius * FOLDED_SIZE : radius;
}

/** Remembers which cells of a row are taken: of thousands of dots only those are drawn that can be seen. */
export class DotGrid {
  private readonly taken: Uint8Array;
  private readonly columns: number;
  private readonly rows: number;

  constructor(width: number, height: number, cell: number) {
    this.columns = Math.ceil(width / cell) + 1;
    this.rows = Math.ceil(height / cell) + 1;
    this.taken = new Uint8Array(this.columns * this.rows);
  }

  /** Whether a cell lies in the row and was free; it no longer is. */
  take(column: number, row: number): boolean {
    if (column < 0 || column >= this.columns || row < 0 || row >= this.rows) return false;
    const index = row * this.columns + column;
    if (this.taken[index] === 1) return false;
    this.taken[index] = 1;
    return true;
  }
}
