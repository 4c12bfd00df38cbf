/** A series reduced to one smallest and one largest value a pixel of the axis: pure geometry. */
import type { Axis } from './axis';
import type { Extremes } from './extremes';

/** Smallest and largest value of a series in each pixel column that it covers. */
export interface Columns {
  /** Pixel of the first column. */
  readonly firstX: number;
  readonly minimum: Float64Array;
  readonly maximum: Float64Array;
}

/**
 * Reduces a series (element n belongs to frame `firstFrame + n`) to the pixel columns of the axis that
 * it covers. A column without a frame of its own takes the value between its neighbours.
 */
export function reduceToColumns(series: Extremes, firstFrame: number, axis: Axis): Columns {
  const origin = axis.x(firstFrame);
  const end = axis.x(firstFrame + Math.max(0, series.values.length - 1));
  const firstX = Math.max(0, Math.round(origin));
  const lastX = Math.min(Math.ceil(axis.width), Math.round(end));
  const count = series.values.length === 0 ? 0 : Math.max(0, lastX - firstX + 1);
  const columns = {
    firstX,
    minimum: new Float64Array(count),
    maximum: new Float64Array(count),
  };
  for (let column = 0; column < count; column++) {
    const from = (firstX + column - 0.5 - origin) / axis.scale;
    reduceColumn(series, from, from + 1 / axis.scale);
    columns.minimum[column] = series.minimum;
    columns.maximum[column] = series.maximum;
  }
  return columns;
}

/** Leaves the extremes between two places of a series in it. */
function reduceColumn(series: Extremes, from: number, to: number): void {
  const last = series.values.length - 1;
  const [begin, end] = [clamp(from, last), clamp(to, last)];
  series.start();
  series.takeValue(between(series.values, begin));
  series.takeValue(between(series.values, end));
  series.take(Math.ceil(begin), Math.floor(end) + 1);
}

function between(values: Float64Array, position: number): number {
  const left = Math.floor(position);
  const right = Math.min(values.length - 1, left + 1);
  return values[left] + (values[right] - values[left]) * (position - left);
}

function clamp(position: number, last: number): number {
  return Math.min(last, Math.max(0, position));
}
