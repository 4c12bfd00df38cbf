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

/** Groups keyposes (frames, ascending) whose pins would touch, from left to right. */
export function layoutPins(frames: ArrayLike<number>, axis: Axis): Pin[] {
  const pins: Pin[] = [];
  let first = 0;
  for (let index = 1; index <= frames.length; index++) {
    if (index < frames.length && touches(frames, index, axis)) continue;
    pins.push({ x: middle(frames, first, index - 1, axis), first, last: index - 1 });
    first = index;
  }
  return pins;
}

function touches(frames: ArrayLike<number>, index: number, axis: Axis): boolean {
  return axis.x(frames[index]) - axis.x(frames[index - 1]) < MINIMUM_DISTANCE;
}

function middle(frames: ArrayLike<number>, first: number, last: number, axis: Axis): number {
  return (axis.x(frames[first]) + axis.x(frames[last])) / 2;
}
