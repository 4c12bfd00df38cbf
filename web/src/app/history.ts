/**
 * What a person did, in order, to be undone and redone. An entry knows how to go both ways; the history
 * knows only which one is next.
 */
import { computed, signal, type ReadonlySignal } from '@preact/signals-core';

export interface Change {
  /** What was done, for the button's tip. */
  readonly label: string;
  readonly apply: () => void;
  readonly revert: () => void;
  /** Called once when the change can no longer be reverted. */
  readonly settle?: () => void;
}

export interface History {
  /** Applies a change and remembers it; what had been undone is forgotten. */
  readonly run: (change: Change) => void;
  /** Applies a change that goes on from the newest one: both are undone together. */
  readonly amend: (change: Omit<Change, 'revert'>) => void;
  readonly undo: () => void;
  readonly redo: () => void;
  readonly next: ReadonlySignal<{
    readonly undo: Change | undefined;
    readonly redo: Change | undefined;
  }>;
}

export const historyLimit = 200;

export function createHistory(limit = historyLimit): History {
  const done = signal<readonly Change[]>([]);
  const undone = signal<readonly Change[]>([]);

  const remember = (change: Change): void => {
    const all = [...done.value, change];
    for (const old of all.slice(0, Math.max(0, all.length - limit))) old.settle?.();
    done.value = all.slice(-limit);
  };

  return {
    run(change) {
      change.apply();
      undone.value = [];
      remember(change);
    },
    amend(change) {
      const newest = done.value.at(-1);
      if (!newest) return;
      change.apply();
      undone.value = [];
      done.value = [...done.value.slice(0, -1), { ...newest, ...change }];
    },
    undo() {
      const change = done.value.at(-1);
      if (!change) return;
      done.value = done.value.slice(0, -1);
      undone.value = [...undone.value, change];
      change.revert();
    },
    redo() {
      const change = undone.value.at(-1);
      if (!change) return;
      undone.value = undone.value.slice(0, -1);
      remember(change);
      change.apply();
    },
    next: computed(() => ({ undo: done.value.at(-1), redo: undone.value.at(-1) })),
  };
}
