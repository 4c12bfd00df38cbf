/** A place on the page in; the stage out, as soon as motions come, and why there is none. */
import { effect, signal, type ReadonlySignal } from '@preact/signals-core';
import type { Store } from '../app/store';
import type { Stage, StageFailure, StageProps } from '../stage';

/** "too-large": the values of the frame shown. */
export type Trouble = StageFailure | 'off' | 'not-loaded' | 'too-large' | null;

export interface LoadedStage {
  readonly stage: ReadonlySignal<Stage | null>;
  readonly trouble: ReadonlySignal<Trouble>;
  /** After a failure. */
  readonly loadAgain: () => void;
}

export function loadStage(place: HTMLElement, store: Store, props: StageProps): LoadedStage {
  const stage = signal<Stage | null>(null);
  const trouble = signal<Trouble>(props.off ? 'off' : null);
  const told: StageProps = {
    ...props,
    onFailure: (reason) => {
      trouble.value = reason;
    },
    onRecovery: () => {
      trouble.value = null;
    },
    onDrawable: (drawable) => {
      trouble.value = drawable ? null : 'too-large';
    },
  };
  // three.js outweighs all the rest: it comes with the first motions, not with the first screen.
  const load = (): void => {
    import('../stage').then(
      ({ Stage }) => {
        stage.value = new Stage(place, told);
      },
      () => {
        trouble.value = 'not-loaded';
      },
    );
  };
  atFirstMotion(store, load);
  return {
    stage,
    trouble,
    loadAgain: () => {
      trouble.value = null;
      load();
    },
  };
}

/** Calls `act` once, as soon as motions are here or on their way. */
function atFirstMotion(store: Store, act: () => void): void {
  let acted = false;
  effect(() => {
    const isDue = store.dropping.value || store.loading.value || store.present.value.length > 0;
    if (acted || !isDue) return;
    acted = true;
    act();
  });
}
