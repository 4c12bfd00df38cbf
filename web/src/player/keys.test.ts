import { expect, test } from 'vitest';
import { commandFor, type KeyFocus, type KeyPress } from './keys';

const press = (key: string, modifiers: Partial<KeyPress> = {}): KeyPress => ({
  key,
  shiftKey: false,
  ctrlKey: false,
  metaKey: false,
  altKey: false,
  ...modifiers,
});
const command = (key: string, modifiers?: Partial<KeyPress>, focus: KeyFocus = 'page') =>
  commandFor(press(key, modifiers), focus);

test('every key of playback has its command', () => {
  expect(command(' ')).toBe('play');
  expect(command('ArrowLeft')).toBe('frame-back');
  expect(command('ArrowRight', { shiftKey: true })).toBe('tenth-on');
  expect(command('k')).toBe('next-keypose');
  expect(command('K', { shiftKey: true })).toBe('previous-keypose');
  expect(command('End')).toBe('last-frame');
  expect(command('+', { shiftKey: true })).toBe('faster');
  expect(command('?', { shiftKey: true })).toBe('help');
  expect(command('[')).toBe('loop-start');
  expect(command(']')).toBe('loop-end');
  expect(command('l')).toBe('loop');
  expect(command('L', { shiftKey: true })).toBe('loop-clear');
  expect(command('z')).toBe('zoom-in');
  expect(command('Z', { shiftKey: true })).toBe('zoom-out');
  expect(command('0')).toBe('zoom-all');
});

test('the ends of the loop on keyboards that write brackets with Alt or AltGr', () => {
  expect(command('[', { altKey: true })).toBe('loop-start');
  expect(command(']', { ctrlKey: true, altKey: true })).toBe('loop-end');
  expect(command('k', { altKey: true })).toBeNull();
});

test('undo and redo, with either modifier', () => {
  expect(command('z', { ctrlKey: true })).toBe('undo');
  expect(command('Z', { metaKey: true, shiftKey: true })).toBe('redo');
  expect(command('y', { ctrlKey: true })).toBe('redo');
  expect(command('k', { ctrlKey: true })).toBeNull();
});

test('a field takes every key, a button Space', () => {
  expect(command('k', {}, 'field')).toBeNull();
  expect(command('z', { ctrlKey: true }, 'field')).toBeNull();
  expect(command(' ', {}, 'button')).toBeNull();
  expect(command('k', {}, 'button')).toBe('next-keypose');
});

test('a field without unwritten changes takes every key but undo', () => {
  expect(command('z', { ctrlKey: true }, 'settled-field')).toBe('undo');
  expect(command('z', {}, 'settled-field')).toBeNull();
  expect(command(']', { ctrlKey: true, altKey: true }, 'settled-field')).toBeNull();
});

test('keys that mean nothing here stay with the browser', () => {
  expect(command('ArrowLeft', { altKey: true })).toBeNull();
  expect(command('Tab')).toBeNull();
  expect(command('Home', { shiftKey: true })).toBeNull();
});
