/**
 * Other values of the method's parameters in; the analysis told, and one step of the history. Changes of
 * one parameter that follow each other quickly, as by a held arrow key, are one step.
 */
import type { MethodOptions } from '../engine/types';
import type { Analysis } from './analysis';
import type { Change, History } from './history';
import type { MessageKey, Words } from './i18n/catalogue';
import type { Store } from './store';

export const joinedWithinMs = 500;

export type OptionKey = keyof MethodOptions;

/** What the history calls a change. */
export const optionLabels: Readonly<Record<OptionKey, MessageKey>> = {
  lowPassHz: 'change.low-pass',
  scaleMaxHz: 'change.scale-max',
  scaleMinHz: 'change.scale-min',
  scaleRatio: 'change.scale-ratio',
  selection: 'change.selection',
};

const optionKeys = Object.keys(optionLabels) as OptionKey[];

export interface OptionChanges {
  readonly set: <Key extends OptionKey>(key: Key, value: MethodOptions[Key] | undefined) => void;
  /** Parameters back to their defaults in one step; without a list, every one. */
  readonly reset: (keys?: readonly OptionKey[]) => void;
}

interface Parts {
  readonly store: Store;
  readonly history: History;
  readonly words: () => Words;
}

export function createOptionChanges(
  { store, history, words }: Parts,
  analysis: Pick<Analysis, 'setOptions'>,
  now: () => number,
): OptionChanges {
  let latest: { key: OptionKey; change: Change | undefined; at: number } | null = null;

  const goesOn = (key: OptionKey): boolean =>
    latest !== null &&
    latest.key === key &&
    latest.change === history.next.peek().undo &&
    now() - latest.at < joinedWithinMs;

  const change = (after: MethodOptions, label: MessageKey, goingOn: boolean): void => {
    const before = store.options.peek();
    const step = { label: words().t(label), apply: () => analysis.setOptions(after) };
    if (goingOn) history.amend(step);
    else history.run({ ...step, revert: () => analysis.setOptions(before) });
  };

  return {
    set(key, value) {
      const { [key]: before, ...others } = store.options.peek();
      const wanted = value === store.defaults.peek()?.[key] ? undefined : value;
      if (before === wanted) return;
      const after = wanted === undefined ? others : { ...others, [key]: wanted };
      change(after, optionLabels[key], goesOn(key));
      latest = { key, change: history.next.peek().undo, at: now() };
    },
    reset(keys = optionKeys) {
      const options = store.options.peek();
      const changed = keys.filter((key) => options[key] !== undefined);
      if (changed.length === 0) return;
      const left = Object.entries(options).filter(([key]) => !keys.includes(key as OptionKey));
      const label = changed.length === 1 ? optionLabels[changed[0]] : 'change.options';
      change(Object.fromEntries(left), label, false);
    },
  };
}
