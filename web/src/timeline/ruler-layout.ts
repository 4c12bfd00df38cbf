/** Where the ruler's ticks stand and what they say: pure geometry. */
import type { Axis } from './axis';

export interface Tick {
  readonly x: number;
  readonly timeS: number;
  readonly frame: number;
  readonly size: 'major' | 'middle' | 'minor';
}

/** How the ruler divides time: a label each `labelled` units, a tick each `tick` units. */
export interface Division {
  readonly unit: 'seconds' | 'frames';
  readonly labelled: number;
  readonly tick: number;
  /** Digits of the seconds in a label. */
  readonly digits: number;
}

/** Distances of labelled ticks, in seconds. */
const STEPS_S = [
  0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600,
];
const STEPS_FRAMES = [1, 2, 5, 10, 20, 50];
/** From here on each frame has a tick of its own, in pixels. */
const FRAME_TICKS = 8;
const LABEL_AIR = 14;
const LABEL_GAP = 5;
const DIGIT = 6.4;
const DIVISIONS = new Map([
  [0.02, 4],
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

/** How wide the widest label of a clip is, in pixels, with `digits` digits of its seconds. */
export function labelWidth(axis: Axis, frameTimeS: number, digits: number): number {
  const { last } = axis.span;
  const frame = String(Math.round(last)).length;
  const time = clockTime(last * frameTimeS, digits).length + (last * frameTimeS < 60 ? 2 : 0);
  return (frame + time) * DIGIT + LABEL_GAP + LABEL_AIR;
}

/** The finest division whose labels do not touch. */
export function divisionOf(axis: Axis, frameTimeS: number): Division {
  if (axis.scale >= FRAME_TICKS) {
    const room = labelWidth(axis, frameTimeS, 3);
    const labelled = STEPS_FRAMES.find((step) => step * axis.scale >= room) ?? 100;
    return { unit: 'frames', labelled, tick: 1, digits: 3 };
  }
  const pixelsPerSecond = axis.scale / frameTimeS;
  const fits = (step: number): boolean =>
    step * pixelsPerSecond >= labelWidth(axis, frameTimeS, digitsOf(step));
  const labelled = STEPS_S.find(fits) ?? longStepS(axis, frameTimeS, pixelsPerSecond);
  const parts = DIVISIONS.get(labelled) ?? 5;
  return { unit: 'seconds', labelled, tick: labelled / parts, digits: digitsOf(labelled) };
}

function digitsOf(stepS: number): number {
  return stepS >= 1 ? 0 : stepS >= 0.1 ? 1 : 2;
}

function longStepS(axis: Axis, frameTimeS: number, pixelsPerSecond: number): number {
  return 3600 * Math.ceil(labelWidth(axis, frameTimeS, 0) / (3600 * pixelsPerSecond));
}

/** The ticks in view, from time 0 to the clip's end. */
export function rulerTicks(axis: Axis, frameTimeS: number, division: Division): Tick[] {
  const frames = division.unit === 'frames' ? division.tick : division.tick / frameTimeS;
  const first = Math.max(0, Math.ceil(Math.max(0, axis.placeAt(0)) / frames - 1e-9));
  const end = Math.min(axis.lastFrame, axis.placeAt(axis.width));
  const count = Math.max(0, Math.floor(end / frames + 1e-9) - first + 1);
  const parts = Math.round(division.labelled / division.tick);
  return Array.from({ length: count }, (_, index) => {
    const frame = (first + index) * frames;
    const timeS = division.unit === 'frames' ? frame * frameTimeS : (first + index) * division.tick;
    const size = tickSize(first + index, parts);
    return { x: axis.x(frame), timeS, frame: Math.round(frame), size };
  });
}

function tickSize(index: number, parts: number): Tick['size'] {
  if (index % parts === 0) return 'major';
  return parts % 2 === 0 && index % (parts / 2) === 0 ? 'middle' : 'minor';
}

/** "0.5" below a minute, "1:30" from there on, "1:02:05" from an hour on. */
export function clockTime(timeS: number, digits: number): string {
  const rounded = Number(timeS.toFixed(digits));
  if (rounded < 60) return rounded.toFixed(digits);
  const minutes = Math.floor(rounded / 60);
  const rest = (rounded - 60 * minutes).toFixed(digits);
  const seconds = rest.padStart(digits > 0 ? digits + 3 : 2, '0');
  if (minutes < 60) return `${minutes}:${seconds}`;
  return `${Math.floor(minutes / 60)}:${String(minutes % 60).padStart(2, '0')}:${seconds}`;
}
