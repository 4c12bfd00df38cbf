/** Which rows of the timeline are folded: as the person left them, or as the window's height suggests. */
import { effect } from '@preact/signals-core';
import type { Preferences } from '../app/preferences';
import type { FoldableRow, Store } from '../app/store';
import { foldableRows } from '../timeline/rows';

const key = 'folded';
/** Below these heights of the window the stage needs the room more than the row. */
const roomFor: Readonly<Record<FoldableRow, number>> = { speed: 560, intensity: 620, scales: 680 };

/** The rows folded at first. */
export function foldedAtFirst(remembered: string | null, windowHeight: number): Set<FoldableRow> {
  const names = remembered?.split(' ');
  return new Set(foldableRows.filter((row) => names?.includes(row) ?? windowHeight < roomFor[row]));
}

export function rememberFolds(store: Store, preferences: Preferences, windowHeight: number): void {
  const first = foldedAtFirst(preferences.get(key), windowHeight);
  store.folded.value = first;
  effect(() => {
    const folded = store.folded.value;
    if (folded !== first) preferences.set(key, [...folded].join(' '));
  });
}
