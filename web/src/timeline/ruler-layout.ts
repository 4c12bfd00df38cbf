/** Where the ruler's ticks stand and what they say: pure geometry. */
import type { Axis } from './axis';

export interface Tick {
  readonly x: number;
  readonly timeS: number;
  readonly frame: number;
  readonly size: 'major' | 'middle' | 'minor';
}

/** Distances of labelled ticks, in seconds. */
const STEPS_S = [0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600];
const LABEL_WIDTH = 82;
const DIVISIONS = new Map([
  [0.2, 4],
  [2, 4],
  [15, 3],
  [30, 6],
  [60, 6],
  [120, 4],
  [900, 3],
  [1800, 6],
  [3600, 6],
]);

/** The smallest step whose labels do not touch. */
export function labelStepS(axis: Axis, frameTimeS: number): number {
  const pixelsPerSecond = axis.scale / frameTimeS;
  return (
    STEPS_S.find((step) => step * pixelsPerSecond >= LABEL_WIDTH) ?? longStepS(pixelsPerSecond)
  );
}

function longStepS(pixelsPerSecond: number): number {
  return 3600 * Math.ceil(LABEL_WIDTH / (3600 * pixelsPerSecond));
}

/** All ticks from time 0 to the clip's end. */
export function rulerTicks(axis: Axis, frameTimeS: number): Tick[] {
  const step = labelStepS(axis, frameTimeS);
  const divisions = DIVISIONS.get(step) ?? 5;
  const count = Math.floor((axis.lastFrame * frameTimeS * divisions) / step + 1e-9);
  return Array.from({ length: count + 1 }, (_, index) => {
    const timeS = (index * step) / divisions;
    const frame = timeS / frameTimeS;
    return { x: axis.x(frame), timeS, frame: Math.round(frame), size: tickSize(index, divisions) };
  });
}

function tickSize(index: number, divisions: number): Tick['size'] {
  if (index % divisions === 0) return 'major';
  return divisions % 2 === 0 && index % (divisions / 2) === 0 ? 'middle' : 'minor';
}
