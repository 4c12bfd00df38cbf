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

/**
 * Remembers which cells of a row hold a dot: of thousands of candidates in a few hundred pixels only
 * those are drawn that can be seen.
 */
export class DotGrid {
  private readonly taken: Uint8Array;
  private readonly across: number;

  constructor(
    width: number,
    height: number,
    private readonly cell: number,
  ) {
    this.across = Math.ceil(width / cell) + 3;
    this.taken = new Uint8Array(this.across * (Math.ceil(height / cell) + 2));
  }

  /** Whether the cell was free; it no longer is. */
  take(x: number, y: number): boolean {
    const column = Math.min(this.across - 1, Math.max(0, Math.floor(x / this.cell) + 1));
    const index = Math.max(0, Math.floor(y / this.cell)) * this.across + column;
    if (this.taken[index] === 1) return false;
    this.taken[index] = 1;
    return true;
  }
}
