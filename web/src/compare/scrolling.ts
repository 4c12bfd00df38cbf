/** How far a list of many rows is scrolled, and how much of it shows. */
import { signal, type ReadonlySignal, type Signal } from '@preact/signals-core';

export interface Scrolling {
  readonly top: Signal<number>;
  readonly height: ReadonlySignal<number>;
}

export const createScrolling = (height: ReadonlySignal<number>): Scrolling => ({
  top: signal(0),
  height,
});
