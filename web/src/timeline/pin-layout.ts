/** Which pins stand alone and which share one lozenge: pure geometry. */
import type { Axis } from './axis';

/** One pin, or several closer than `MINIMUM_DISTANCE` pixels under one count. */
export interface Pin {
  readonly x: number;
  /** First and last keypose (index in time order) under this pin. */
  readonly first: number;
  readonly last: number;
}

export const MINIMUM_DISTANCE = 12;
/** A run of pins without a gap is cut into lozenges that are this wide at least, in pixels. */
const LOZENGE_REACH = 40;
const DISC_WIDTH = 12;
const AIR = 2;

/** Width of what is drawn for so many keyposes. */
export function pinWidth(count: number): number {
  if (count === 1) return DISC_WIDTH;
  return Math.max(26, 12 + 7 * String(count).length);
}

/**
 * Groups keyposes (frames, ascending) whose pins would touch, from left to right. The groups depend on
 * the scale alone: they stay as they are while the axis is moved.
 */
export function layoutPins(frames: ArrayLike<number>, axis: Axis): Pin[] {
  const pins: Pin[] = [];
  let first = 0;
  for (let index = 1; index <= frames.length; index++) {
    if (index < frames.length && touches(frames, index, axis)) continue;
    divideRun(frames, first, index - 1, axis, pins);
    first = index;
  }
  return pins;
}

function touches(frames: ArrayLike<number>, index: number, axis: Axis): boolean {
  return (frames[index] - frames[index - 1]) * axis.scale < MINIMUM_DISTANCE;
}

/** A long run becomes several lozenges, each over its own keyposes. */
function divideRun(
  frames: ArrayLike<number>,
  first: number,
  last: number,
  axis: Axis,
  pins: Pin[],
): void {
  const length = frames[last] - frames[first];
  const parts = Math.max(1, Math.floor((length * axis.scale) / LOZENGE_REACH));
  let start = first;
  for (let part = 1; part <= parts && start <= last; part++) {
    const end = frames[first] + (length * part) / parts;
    let next = start;
    while (next < last && (part === parts || frames[next + 1] <= end)) next++;
    add(pins, pinOf(frames, start, next, axis), frames, axis);
    start = next + 1;
  }
}

/** Adds a pin; one that would overlap the pin before it joins that. */
function add(pins: Pin[], pin: Pin, frames: ArrayLike<number>, axis: Axis): void {
  const before = pins.at(-1);
  if (before === undefined || !overlap(before, pin)) {
    pins.push(pin);
    return;
  }
  pins.pop();
  add(pins, pinOf(frames, before.first, pin.last, axis), frames, axis);
}

/** Two single pins may touch, as far as `MINIMUM_DISTANCE` lets them. */
function overlap(a: Pin, b: Pin): boolean {
  const [some, others] = [a.last - a.first + 1, b.last - b.first + 1];
  if (some === 1 && others === 1) return false;
  return b.x - a.x < (pinWidth(some) + pinWidth(others)) / 2 + AIR;
}

function pinOf(frames: ArrayLike<number>, first: number, last: number, axis: Axis): Pin {
  return { x: (axis.x(frames[first]) + axis.x(frames[last])) / 2, first, last };
}
