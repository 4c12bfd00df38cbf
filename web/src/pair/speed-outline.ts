/** A clip's speed and its axis in; line and area of its row out: pure geometry. */
import type { KeyposeResult } from '../engine/types';
import type { Axis } from '../timeline/axis';
import { Extremes } from '../timeline/extremes';
import { curveOf } from '../timeline/speed-curve';
import type { RowPlace } from './rows-layout';

export interface SpeedOutline {
  /** SVG path data. */
  readonly line: string;
  readonly area: string;
}

const HEADROOM = 1.05;
const AIR = 6;
const FOOT = 2;

/** `maximum`: the largest speed of both clips, so that their rows can be compared. */
export function speedOutline(
  { speed, firstFrame }: Pick<KeyposeResult, 'speed' | 'firstFrame'>,
  axis: Axis,
  row: RowPlace,
  maximum: number,
): SpeedOutline {
  const series = extremesOf(speed);
  const { x, minimum, maximum: largest } = curveOf(series, firstFrame, axis);
  const base = row.top + row.height - FOOT;
  const reach = maximum > 0 ? (row.height - AIR) / (maximum * HEADROOM) : 0;
  const point = (i: number, value: number): string => `${px(x[i])} ${px(base - value * reach)}`;
  if (x.length === 0) return { line: '', area: '' };
  const upper = Array.from(x, (_, i) => point(i, largest[i]));
  // Where a pixel holds many frames the line goes down to their smallest and up again.
  const line = upper.map((place, i) =>
    minimum[i] === largest[i] ? place : `${point(i, minimum[i])}L${place}`,
  );
  return {
    line: `M${line.join('L')}`,
    area: `M${px(x[0])} ${base}L${upper.join('L')}L${px(x[x.length - 1])} ${base}Z`,
  };
}

/** Of a clip of an hour they take as long as all the rest. */
const known = new WeakMap<Float64Array, Extremes>();

function extremesOf(speed: Float64Array): Extremes {
  const found = known.get(speed);
  if (found) return found;
  const series = new Extremes(speed);
  series.build(Infinity);
  known.set(speed, series);
  return series;
}

const px = (value: number): string => String(Math.round(value * 100) / 100);
