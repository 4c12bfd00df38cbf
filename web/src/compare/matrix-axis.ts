/**
 * Groups of positions and room in; where each cell of one side of the matrix begins out, in pixels,
 * with a gap wherever the group changes.
 */
export interface Fit {
  readonly cell: number;
  readonly gap: number;
}

export const mostCellPx = 18;
export const leastNamedCellPx = 9;
const usualGapPx = 4;
/** Gaps of many groups together take no more of the room than this. */
const mostGaps = 0.12;

const changes = (groups: Int32Array): number =>
  groups.reduce((sum, group, k) => sum + (k > 0 && group !== groups[k - 1] ? 1 : 0), 0);

/** The largest cells, whole pixels if they are not tiny, with which everything has room. */
export function fitAxis(groups: Int32Array, roomPx: number): Fit {
  if (groups.length === 0) return { cell: mostCellPx, gap: 0 };
  const gaps = changes(groups);
  const wanted = gaps === 0 ? 0 : Math.min(usualGapPx, (mostGaps * roomPx) / gaps);
  // Thinner ones would be drawn in some places and not in others.
  const gap = wanted < 1 ? 0 : Math.floor(wanted);
  const cell = Math.max(0, roomPx - gap * gaps) / groups.length;
  return { cell: Math.min(mostCellPx, cell >= 3 ? Math.floor(cell) : cell), gap };
}

export class MatrixAxis {
  readonly count: number;
  readonly cell: number;
  readonly length: number;
  private readonly starts: Float64Array;

  constructor(groups: Int32Array, { cell, gap }: Fit) {
    this.count = groups.length;
    this.cell = cell;
    this.starts = new Float64Array(groups.length);
    let at = 0;
    for (let k = 0; k < groups.length; k += 1) {
      if (k > 0) at += cell + (groups[k] === groups[k - 1] ? 0 : gap);
      this.starts[k] = at;
    }
    this.length = groups.length === 0 ? 0 : at + cell;
  }

  start(position: number): number {
    return this.starts[position] ?? 0;
  }

  middle(position: number): number {
    return this.start(position) + this.cell / 2;
  }

  /** The position whose cell or following gap is at a pixel, held within the axis. */
  nearest(pixel: number): number {
    let [low, high] = [0, this.count - 1];
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.starts[middle] <= pixel) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  /** The position whose cell is at a pixel; −1 in a gap and outside. */
  at(pixel: number): number {
    if (this.count === 0 || pixel < 0) return -1;
    const position = this.nearest(pixel);
    return pixel < this.starts[position] + this.cell ? position : -1;
  }
}

/** The position under each of a row of device pixels; −1 between groups and outside. */
export function positionsUnder(
  axis: MatrixAxis,
  scroll: number,
  pixels: number,
  ratio: number,
): Int32Array {
  const positions = new Int32Array(pixels);
  for (let k = 0; k < pixels; k += 1) positions[k] = axis.at(scroll + (k + 0.5) / ratio);
  return positions;
}
