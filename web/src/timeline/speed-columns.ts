/** The speed curve reduced to one smallest and one largest value a pixel: pure geometry. */
import type { Axis } from './axis';

/** Smallest and largest value of a series in each pixel column that it covers. */
export interface Columns {
  /** Pixel of the first column. */
  readonly firstX: number;
  readonly minimum: Float64Array;
  readonly maximum: Float64Array;
}

/**
 * Reduces `values` (element n belongs to frame `firstFrame + n`) to pixel columns. A column
 * without a frame of its own takes the value between its neighbours.
 */
export function reduceToColumns(values: Float64Array, firstFrame: number, axis: Axis): Columns {
  const firstX = Math.round(axis.x(firstFrame));
  const lastX = Math.round(axis.x(firstFrame + values.length - 1));
  const count = Math.max(1, lastX - firstX + 1);
  const minimum = new Float64Array(count);
  const maximum = new Float64Array(count);
  for (let column = 0; column < count; column++) {
    reduceColumn(values, firstFrame, axis, firstX + column, column, minimum, maximum);
  }
  return { firstX, minimum, maximum };
}

function reduceColumn(
  values: Float64Array,
  firstFrame: number,
  axis: Axis,
  x: number,
  column: number,
  minimum: Float64Array,
  maximum: Float64Array,
): void {
  const origin = axis.x(firstFrame);
  const from = clamp((x - 0.5 - origin) / axis.scale, values.length - 1);
  const to = clamp((x + 0.5 - origin) / axis.scale, values.length - 1);
  let low = Math.min(between(values, from), between(values, to));
  let high = Math.max(between(values, from), between(values, to));
  for (let index = Math.ceil(from); index <= to; index++) {
    low = Math.min(low, values[index]);
    high = Math.max(high, values[index]);
  }
  minimum[column] = low;
  maximum[column] = high;
}

function between(values: Float64Array, position: number): number {
  const left = Math.floor(position);
  const right = Math.min(values.length - 1, left + 1);
  return values[left] + (values[right] - values[left]) * (position - left);
}

function clamp(position: number, last: number): number {
  return Math.min(last, Math.max(0, position));
}
