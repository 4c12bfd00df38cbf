/** How far A is ahead along a warping path, B's axis in; the outlines of the row out: pure geometry. */
import type { Warping } from '../engine/comparison-types';
import type { Axis } from '../timeline/axis';
import { rows } from './rows-layout';

export interface AheadOutline {
  /** SVG path data of the areas where A is ahead, and where B is. */
  readonly a: string;
  readonly b: string;
  /** The most that either is ahead, 0 to 1. */
  readonly most: number;
}

const HEADROOM = 1.1;
const AIR = 4;

export const AHEAD_MIDDLE = rows.ahead.top + rows.ahead.height / 2;

export function aheadOutline({ pathB, ahead }: Warping, axis: Axis): AheadOutline {
  const { x, value } = byPixel(pathB, ahead, axis);
  const most = value.reduce((largest, one) => Math.max(largest, Math.abs(one)), 0);
  const reach = most > 0 ? (rows.ahead.height / 2 - AIR) / (most * HEADROOM) : 0;
  const area = (sign: 1 | -1): string => {
    if (x.length === 0) return '';
    const points = x.map((at, i) => {
      const up = Math.max(0, value[i] * sign) * sign * reach;
      return `L${round(at)} ${round(AHEAD_MIDDLE - up)}`;
    });
    return `M${round(x[0])} ${AHEAD_MIDDLE}${points.join('')}L${round(x[x.length - 1])} ${AHEAD_MIDDLE}Z`;
  };
  return { a: area(1), b: area(-1), most };
}

/** Of the steps that share half a pixel the one farthest from even. */
function byPixel(pathB: Int32Array, ahead: Float64Array, axis: Axis) {
  const x: number[] = [];
  const value: number[] = [];
  for (let step = 0; step < pathB.length; step++) {
    const at = axis.x(pathB[step]);
    const last = x.length - 1;
    if (last >= 0 && at - x[last] < 0.5) {
      if (Math.abs(ahead[step]) > Math.abs(value[last])) value[last] = ahead[step];
    } else {
      x.push(at);
      value.push(ahead[step]);
    }
  }
  return { x, value };
}

const round = (value: number): number => Math.round(value * 100) / 100;
