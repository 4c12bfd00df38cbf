/** How far A is ahead along a warping path, B's axis in; the outlines of the row out: pure geometry. */
import type { Warping } from '../engine/comparison-types';
import type { Axis } from '../timeline/axis';
import { within } from '../timeline/sorted';
import { rows } from './rows-layout';

export interface AheadOutline {
  /** SVG path data of the areas where A is ahead, and where B is. */
  readonly a: string;
  readonly b: string;
  /** What the full height of either side stands for, 0 to 1. */
  readonly scale: number;
  /** Where "A" and "B" end so that the areas leave them free, in pixels. */
  readonly labelEnds: readonly [number, number];
}

/** Leads that are smaller do not fill the row: nobody would call them leads. */
const LEAST_SCALE = 0.05;
const AIR = 4;
const REACH = rows.ahead.height / 2 - AIR;
/** The room of a label, and the air between it and the edge, in pixels. */
const LABEL = { width: 52, height: 16, edge: 4 };

export const AHEAD_MIDDLE = rows.ahead.top + rows.ahead.height / 2;

interface Points {
  readonly x: readonly number[];
  /** Pixels above the middle. */
  readonly up: readonly number[];
}

export function aheadOutline({ pathB, ahead }: Warping, axis: Axis): AheadOutline {
  const most = ahead.reduce((largest, one) => Math.max(largest, Math.abs(one)), LEAST_SCALE);
  const scale = Math.ceil(100 * most - 1e-9) / 100;
  const points = byPixel(pathB, ahead, axis, REACH / scale);
  return {
    a: area(points, 1),
    b: area(points, -1),
    scale,
    labelEnds: [clearEnd(points, 1, axis.width), clearEnd(points, -1, axis.width)],
  };
}

function area({ x, up }: Points, sign: 1 | -1): string {
  if (x.length === 0) return '';
  const line = x.map((at, i) => {
    const height = Math.max(0, up[i] * sign) * sign;
    return `L${round(at)} ${round(AHEAD_MIDDLE - height)}`;
  });
  return `M${round(x[0])} ${AHEAD_MIDDLE}${line.join('')}L${round(x[x.length - 1])} ${AHEAD_MIDDLE}Z`;
}

/** The rightmost place where an area stays below a label; at the right edge where there is none. */
function clearEnd({ x, up }: Points, sign: 1 | -1, width: number): number {
  const right = width - LABEL.edge;
  let end = right;
  for (let i = x.length - 1; i >= 0 && x[i] > end - LABEL.width; i--) {
    const isHigh = up[i] * sign > REACH + AIR - LABEL.height;
    if (isHigh && x[i] < end + LABEL.edge) end = x[i] - LABEL.edge;
  }
  return end - LABEL.width < 0 ? right : end;
}

/** Of the steps in view that share half a pixel the one farthest from even. */
function byPixel(pathB: Int32Array, ahead: Float64Array, axis: Axis, reach: number): Points {
  const x: number[] = [];
  const up: number[] = [];
  const { from, to } = within(pathB, axis.placeAt(0), axis.placeAt(axis.width));
  for (let step = Math.max(0, from - 1); step < Math.min(pathB.length, to + 1); step++) {
    const [at, height] = [axis.x(pathB[step]), ahead[step] * reach];
    const last = x.length - 1;
    if (last >= 0 && at - x[last] < 0.5) {
      if (Math.abs(height) > Math.abs(up[last])) up[last] = height;
    } else {
      x.push(at);
      up.push(height);
    }
  }
  return { x, up };
}

const round = (value: number): number => Math.round(value * 100) / 100;
