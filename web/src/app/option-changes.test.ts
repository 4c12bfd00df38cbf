import { expect, test } from 'vitest';
import type { MethodOptions } from '../engine/types';
import { createHistory } from './history';
import { wordsFor } from './i18n/catalogue';
import { createOptionChanges, joinedWithinMs } from './option-changes';
import { createStore } from './store';

function harness() {
  const store = createStore();
  const history = createHistory();
  store.defaults.value = {
    lowPassHz: 10,
    scaleMaxHz: 8,
    scaleMinHz: 0.2,
    scaleRatio: 0.95,
    selection: 'automatic',
  };
  const clock = { ms: 0 };
  const setOptions = (options: MethodOptions): void => {
    store.options.value = options;
  };
  const changes = createOptionChanges(
    { store, history, words: () => wordsFor('en') },
    { setOptions },
    () => clock.ms,
  );
  return { store, history, changes, clock, options: () => store.options.value };
}

test('a value and its way back', () => {
  const { changes, history, options } = harness();
  changes.set('lowPassHz', 6);
  expect(options()).toEqual({ lowPassHz: 6 });
  expect(history.next.value.undo?.label).toBe('low-pass cut-off');
  history.undo();
  expect(options()).toEqual({});
  history.redo();
  expect(options()).toEqual({ lowPassHz: 6 });
});

test('the default is no change, and ends one', () => {
  const { changes, history, options } = harness();
  changes.set('scaleRatio', 0.95);
  expect(history.next.value.undo).toBeUndefined();
  changes.set('scaleRatio', 0.9);
  changes.set('scaleRatio', 0.95);
  expect(options()).toEqual({});
});

test('quick changes of one parameter are one step', () => {
  const { changes, history, clock, options } = harness();
  for (const value of [9, 8, 7]) {
    changes.set('lowPassHz', value);
    clock.ms += joinedWithinMs - 1;
  }
  history.undo();
  expect(options()).toEqual({});
  history.redo();
  expect(options()).toEqual({ lowPassHz: 7 });
});

test('slow ones, those of another parameter and those after an undo are steps of their own', () => {
  const { changes, history, clock, options } = harness();
  changes.set('lowPassHz', 9);
  clock.ms += joinedWithinMs;
  changes.set('lowPassHz', 8);
  changes.set('scaleMaxHz', 6);
  changes.set('lowPassHz', 7);
  history.undo();
  expect(options()).toEqual({ lowPassHz: 8, scaleMaxHz: 6 });
  history.undo();
  changes.set('lowPassHz', 5);
  history.undo();
  expect(options()).toEqual({ lowPassHz: 8 });
  history.undo();
  expect(options()).toEqual({ lowPassHz: 9 });
});

test('reset takes all back in one step', () => {
  const { changes, history, options } = harness();
  changes.set('lowPassHz', 9);
  changes.set('selection', 'literal');
  changes.reset();
  expect(options()).toEqual({});
  history.undo();
  expect(options()).toEqual({ lowPassHz: 9, selection: 'literal' });
});

test('some of them too, in one step', () => {
  const { changes, history, options } = harness();
  changes.set('scaleMaxHz', 6);
  changes.set('scaleMinHz', 0.5);
  changes.set('selection', 'literal');
  changes.reset(['scaleMaxHz', 'scaleMinHz']);
  expect(options()).toEqual({ selection: 'literal' });
  expect(history.next.value.undo?.label).toBe('parameters');
  history.undo();
  expect(options()).toEqual({ scaleMaxHz: 6, scaleMinHz: 0.5, selection: 'literal' });
});
