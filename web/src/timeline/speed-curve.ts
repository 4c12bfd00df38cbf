/** A series reduced to what an axis can show of it: its points, or a band a pixel wide. Pure geometry. */
import type { Axis } from './axis';
import type { Extremes } from './extremes';

/** Places in pixels with the values there; smallest and largest are one where frames are far apart. */
export interface Curve {
  readonly x: Float64Array;
  readonly minimum: Float64Array;
  readonly maximum: Float64Array;
}

/** From so many pixels a frame on, the curve goes from frame to frame. */
const FRAMES_APART = 1;

/** The part of a series (element n belongs to frame `firstFrame + n`) that the axis shows. */
export function curveOf(series: Extremes, firstFrame: number, axis: Axis): Curve {
  return axis.scale >= FRAMES_APART
    ? framePoints(series.values, firstFrame, axis)
    : pixelColumns(series, firstFrame, axis);
}

/** Every frame in view and the next on either side. */
function framePoints(values: Float64Array, firstFrame: number, axis: Axis): Curve {
  const end = firstFrame + values.length;
  const from = Math.max(firstFrame, Math.floor(axis.placeAt(0)));
  const to = Math.min(end, Math.ceil(axis.placeAt(axis.width)) + 1);
  const shown = values.subarray(from - firstFrame, Math.max(from, to) - firstFrame);
  const x = new Float64Array(shown.length);
  for (let index = 0; index < x.length; index++) x[index] = axis.x(from + index);
  return { x, minimum: shown, maximum: shown };
}

/** Smallest and largest value of each pixel column, with what lies between two frames. */
function pixelColumns(series: Extremes, firstFrame: number, axis: Axis): Curve {
  const origin = axis.x(firstFrame);
  const end = axis.x(firstFrame + Math.max(0, series.values.length - 1));
  const firstX = Math.max(0, Math.round(origin));
  const lastX = Math.min(Math.ceil(axis.width), Math.round(end));
  const count = series.values.length === 0 ? 0 : Math.max(0, lastX - firstX + 1);
  const [x, minimum, maximum] = [0, 1, 2].map(() => new Float64Array(count));
  for (let column = 0; column < count; column++) {
    const from = (firstX + column - 0.5 - origin) / axis.scale;
    takeBetween(series, from, from + 1 / axis.scale);
    x[column] = firstX + column;
    minimum[column] = series.minimum;
    maximum[column] = series.maximum;
  }
  return { x, minimum, maximum };
}

/** Leaves the extremes between two places of a series in it. */
function takeBetween(series: Extremes, from: number, to: number): void {
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
