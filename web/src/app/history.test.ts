import { expect, test, vi } from 'vitest';
import { createHistory, type Change } from './history';

function change(log: string[], label: string, settle?: () => void): Change {
  const write = (what: string) => () => void log.push(`${what} ${label}`);
  return { label, apply: write('do'), revert: write('undo'), ...(settle ? { settle } : {}) };
}

test('changes go back and forth in order', () => {
  const log: string[] = [];
  const history = createHistory();
  history.run(change(log, 'a'));
  history.run(change(log, 'b'));
  history.undo();
  history.undo();
  history.redo();
  expect(log).toEqual(['do a', 'do b', 'undo b', 'undo a', 'do a']);
  expect(history.next.value.undo?.label).toBe('a');
  expect(history.next.value.redo?.label).toBe('b');
});

test('a new change forgets what had been undone', () => {
  const log: string[] = [];
  const history = createHistory();
  history.run(change(log, 'a'));
  history.undo();
  history.run(change(log, 'b'));
  history.redo();
  expect(log).toEqual(['do a', 'undo a', 'do b']);
});

test('undo and redo of nothing do nothing', () => {
  const history = createHistory();
  history.undo();
  history.redo();
  expect(history.next.value).toEqual({ undo: undefined, redo: undefined });
});

test('a change beyond the limit settles once', () => {
  const settle = vi.fn();
  const history = createHistory(2);
  history.run(change([], 'a', settle));
  history.run(change([], 'b'));
  expect(settle).not.toHaveBeenCalled();
  history.run(change([], 'c'));
  history.run(change([], 'd'));
  expect(settle).toHaveBeenCalledTimes(1);
});
