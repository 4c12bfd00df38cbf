/** The open performer and the joints that a person chose in; the joints whose trails are drawn out. */
import { computed, signal, type ReadonlySignal } from '@preact/signals-core';
import type { Store } from '../app/store';

export interface TrailChoice {
  readonly joints: ReadonlySignal<readonly number[]>;
  /** Whether they are the ones found. */
  readonly asFound: ReadonlySignal<boolean>;
  /** Draws the joint's trail or no longer; one that is not on the stage comes there. */
  readonly toggle: (joint: number) => void;
  /** Back to the ones found. */
  readonly reset: () => void;
}

export function createTrailChoice(store: Store): TrailChoice {
  // By clip and performer, for as long as the page lives.
  const chosen = signal<ReadonlyMap<string, readonly number[]>>(new Map());
  const key = computed(() => `${store.openId.value} ${store.performer.value}`);
  const own = computed(() => chosen.value.get(key.value));
  const found = computed(() => [...(store.openPerformer.value?.trailJoints ?? [])]);
  const joints = computed(() => own.value ?? found.value);
  const choose = (next: readonly number[] | null): void => {
    const map = new Map(chosen.peek());
    if (next === null) map.delete(key.peek());
    else map.set(key.peek(), next);
    chosen.value = map;
  };
  return {
    joints,
    asFound: computed(() => own.value === undefined),
    toggle(joint) {
      const now = joints.peek();
      const drawn = now.includes(joint);
      if (!store.trails.peek()) {
        store.trails.value = true;
        if (drawn) return;
      }
      choose(drawn ? now.filter((other) => other !== joint) : [...now, joint]);
    },
    reset: () => choose(null),
  };
}
