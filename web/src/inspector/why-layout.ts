/** The traces of the keyposes and a width in; curves of u over the time scales, their axis and hits out. */
import type { KeyposeResult } from '../engine/types';

export const chartHeight = 74;
/** Of the curve's foot and of its highest place. */
export const baseline = chartHeight - 16;
const summit = 6;
/** The greatest u of all keyposes stays this far below the top. */
const headroom = 1.05;
/** More curves than this would be a grey field; the most intense are shown. */
export const mostCurves = 200;
const leastTickGap = 26;
const hitPx = 10;

export interface Curve {
  readonly candidate: number;
  /** x, y, x, y … from fine to coarse. */
  readonly points: readonly number[];
}

export interface Tick {
  readonly x: number;
  readonly hz: number;
}

export interface ScaleAxis {
  readonly x: (hz: number) => number;
  readonly ticks: readonly Tick[];
}

const powersOfTwo = Array.from({ length: 18 }, (_, power) => 2 ** power).reverse();
const roundHz = [...powersOfTwo, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01];

/** `coarsestHz`: as it was asked for; the scales may end before, where no minimum is left. */
export function scaleAxis(
  scalesHz: ArrayLike<number>,
  coarsestHz: number,
  width: number,
): ScaleAxis {
  const finest = scalesHz[0] ?? 1;
  const coarsest = Math.min(coarsestHz, scalesHz[scalesHz.length - 1] ?? finest);
  const octaves = Math.log2(finest / coarsest);
  const x = (hz: number): number =>
    octaves > 0 ? (Math.log2(finest / hz) / octaves) * width : width / 2;
  const ends = octaves > 0 ? [finest, coarsest] : [finest];
  const between = roundHz.filter((hz) => hz < finest && hz > coarsest);
  const room = between.filter((hz) => x(hz) >= leastTickGap && x(hz) <= width - leastTickGap * 1.5);
  const spaced = room.filter(
    (hz, index) => index === 0 || x(hz) - x(room[index - 1] ?? hz) >= leastTickGap,
  );
  const all = [ends[0] ?? finest, ...spaced, ...ends.slice(1)];
  return { x, ticks: all.map((hz) => ({ hz, x: x(hz) })) };
}

/** The most intense of them, if they are too many. */
function shown({ keyposes, byIntensity }: KeyposeResult): readonly number[] {
  if (keyposes.length <= mostCurves) return [...keyposes];
  const kept = new Set(keyposes);
  return [...byIntensity].filter((candidate) => kept.has(candidate)).slice(0, mostCurves);
}

function largestU({ keyposes, traceOffsets, traceIntensities }: KeyposeResult): number {
  let largest = 0;
  for (const candidate of keyposes) {
    const end = traceOffsets[candidate + 1] ?? 0;
    for (let at = traceOffsets[candidate] ?? 0; at < end; at++)
      largest = Math.max(largest, traceIntensities[at] ?? 0);
  }
  return largest;
}

export interface WhyCurves {
  readonly axis: ScaleAxis;
  /** Of the keyposes. */
  readonly curves: readonly Curve[];
  readonly curveOf: (candidate: number) => Curve;
}

export function whyCurves(result: KeyposeResult, coarsestHz: number, width: number): WhyCurves {
  const { scalesHz, traceOffsets, traceScales, traceIntensities } = result;
  const axis = scaleAxis(scalesHz, coarsestHz, width);
  const unit = (baseline - summit) / (largestU(result) * headroom || 1);
  const curveOf = (candidate: number): Curve => {
    const points: number[] = [];
    const end = traceOffsets[candidate + 1] ?? 0;
    for (let at = traceOffsets[candidate] ?? 0; at < end; at++) {
      const u = traceIntensities[at] ?? 0;
      points.push(
        axis.x(scalesHz[traceScales[at] ?? 0] ?? 1),
        Math.max(summit, baseline - u * unit),
      );
    }
    return { candidate, points };
  };
  return { axis, curves: shown(result).map(curveOf), curveOf };
}

const rounded = (value: number): number => Math.round(value * 10) / 10;

/** SVG path data of a curve. */
export function curvePath({ points }: Curve): string {
  let path = '';
  for (let at = 0; at + 1 < points.length; at += 2)
    path += `${at === 0 ? 'M' : 'L'}${rounded(points[at] ?? 0)} ${rounded(points[at + 1] ?? 0)}`;
  return path;
}

/** The same, closed along the foot. */
export function areaPath(curve: Curve): string {
  const { points } = curve;
  if (points.length === 0) return '';
  const [first = 0] = points;
  const last = points[points.length - 2] ?? first;
  return `${curvePath(curve)}L${rounded(last)} ${baseline}L${rounded(first)} ${baseline}Z`;
}

/** The candidate whose curve runs nearest below or above a place; null if none is near. */
export function curveAt(curves: readonly Curve[], x: number, y: number): number | null {
  let best: number | null = null;
  let least = hitPx;
  for (const { candidate, points } of curves) {
    for (let at = 0; at + 1 < points.length; at += 2) {
      const away = Math.hypot((points[at] ?? 0) - x, (points[at + 1] ?? 0) - y);
      if (away < least) [best, least] = [candidate, away];
    }
  }
  return best;
}
