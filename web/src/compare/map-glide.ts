/** Scenes in; the places of their items out, gliding from the old ones to the new. */
import { effect, signal, type ReadonlySignal } from '@preact/signals-core';
import type { ClipId } from '../engine/types';
import { between } from './map-layout';
import type { Scene } from './scene';

const glideMs = 400;

const ease = (part: number): number => 1 - (1 - part) ** 3;

/** Where the clips of the new scene stood; those that are new stand at their place at once. */
export function oldPlaces(
  ids: Int32Array,
  places: Float64Array,
  before: ReadonlyMap<ClipId, number>,
  shown: Float64Array,
): Float64Array {
  return places.map((value, k) => {
    const item = before.get(ids[k >> 1]);
    return item === undefined ? value : shown[2 * item + (k & 1)];
  });
}

export class MapGlide {
  readonly places = signal<Float64Array>(new Float64Array());
  readonly gliding = signal(false);
  private before: Scene | null = null;
  private run = 0;

  constructor(scene: ReadonlySignal<Scene | null>) {
    effect(() => {
      const next = scene.value;
      if (next?.comparison === this.before?.comparison) return;
      this.begin(next);
      this.before = next;
    });
  }

  private begin(next: Scene | null): void {
    cancelAnimationFrame(this.run);
    const target = next?.comparison.map ?? new Float64Array();
    const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
    if (!next || !this.before || still) return this.arrive(target);
    const { clips } = next.comparison;
    const from = oldPlaces(clips, target, this.before.itemOfClip, this.places.peek());
    if (from.every((value, k) => value === target[k])) return this.arrive(target);
    this.gliding.value = true;
    this.places.value = from;
    const startMs = performance.now();
    const step = (): void => {
      const part = (performance.now() - startMs) / glideMs;
      if (part >= 1) return this.arrive(target);
      this.places.value = between(from, target, ease(part));
      this.run = requestAnimationFrame(step);
    };
    this.run = requestAnimationFrame(step);
  }

  private arrive(target: Float64Array): void {
    this.places.value = target;
    this.gliding.value = false;
  }
}
