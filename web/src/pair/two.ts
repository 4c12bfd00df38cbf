/** The two clips of the rows, with their axes. */
import type { ReadonlySignal } from '@preact/signals-core';
import type { Axis } from '../timeline/axis';
import type { PairClip } from './pair-clips';

export interface Two {
  readonly a: PairClip;
  readonly b: PairClip;
  readonly axes: readonly [Axis, Axis];
}

/** null while there are fewer. */
export type TwoSignal = ReadonlySignal<Two | null>;
