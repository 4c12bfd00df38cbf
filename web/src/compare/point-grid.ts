/** Points in; whether any of them is in a box out, without a look at each. */
import type { Point } from './hull';
import type { Box } from './map-layout';

const cellPx = 32;

const cellOf = (value: number): number => Math.floor(value / cellPx);

export class PointGrid {
  /** By row and column of their cell. */
  private readonly rows = new Map<number, Map<number, Point[]>>();

  constructor(points: readonly Point[]) {
    for (const point of points) {
      const [column, row] = [cellOf(point[0]), cellOf(point[1])];
      const columns = this.rows.get(row) ?? new Map<number, Point[]>();
      const cell = columns.get(column) ?? [];
      cell.push(point);
      columns.set(column, cell);
      this.rows.set(row, columns);
    }
  }

  /** Whether a point is nearer than `reach` to the box, along both axes; on its edge is outside. */
  isNear(box: Box, reach: number): boolean {
    const [left, right] = [box.left - reach, box.right + reach];
    const [top, bottom] = [box.top - reach, box.bottom + reach];
    const isIn = ([x, y]: Point): boolean => x > left && x < right && y > top && y < bottom;
    for (let row = cellOf(top); row <= cellOf(bottom); row += 1) {
      const columns = this.rows.get(row);
      if (!columns) continue;
      for (let column = cellOf(left); column <= cellOf(right); column += 1)
        if (columns.get(column)?.some(isIn)) return true;
    }
    return false;
  }
}
