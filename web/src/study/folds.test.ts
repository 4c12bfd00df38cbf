import { describe, expect, it } from 'vitest';
import { createPreferences } from '../app/preferences';
import { createStore } from '../app/store';
import { foldedAtFirst, rememberFolds } from './folds';

describe('foldedAtFirst', () => {
  it('goes by the height of the window until somebody has folded a row', () => {
    expect([...foldedAtFirst(null, 900)]).toEqual([]);
    expect([...foldedAtFirst(null, 650)]).toEqual(['scales']);
    expect([...foldedAtFirst(null, 450)]).toEqual(['speed', 'scales', 'intensity']);
    expect([...foldedAtFirst('', 450)]).toEqual([]);
    expect([...foldedAtFirst('intensity nonsense', 900)]).toEqual(['intensity']);
  });
});

describe('rememberFolds', () => {
  it('remembers what a person folds, and nothing before', () => {
    const kept = new Map<string, string>();
    const storage = {
      getItem: (key: string) => kept.get(key) ?? null,
      setItem: (key: string, value: string) => kept.set(key, value),
    };
    const preferences = createPreferences(() => storage as unknown as Storage);
    const store = createStore();
    rememberFolds(store, preferences, 650);
    expect(kept.size).toBe(0);
    store.folded.value = new Set(['speed']);
    expect(preferences.get('folded')).toBe('speed');
  });
});
