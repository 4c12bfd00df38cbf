import { expect, test } from 'vitest';
import { wordsFor } from '../app/i18n/catalogue';
import { captionOf, type Moment } from './caption';

const moment = (fields: Partial<Moment>): Moment => ({
  frame: 338,
  frameTimeS: 1 / 120,
  keyposes: Int32Array.of(100, 338),
  current: 1,
  leadingRestFrames: 0,
  ...fields,
});
const words = wordsFor('en');

test('at a keypose it is named and spoken', () => {
  const caption = captionOf(words, moment({}));
  expect(caption).toEqual({
    title: 'Keypose 2 of 2',
    remark: '',
    spoken: 'Keypose 2 of 2, 2.82 seconds',
  });
});

test('a frame or more away from it, how far is added', () => {
  expect(captionOf(words, moment({ frame: 345 })).remark).toBe('0.06 s past it');
  expect(captionOf(words, moment({ frame: 337 })).remark).toBe('0.01 s before it');
});

test('a leading rest pose is told', () => {
  expect(captionOf(words, moment({ frame: 0, current: 0, leadingRestFrames: 1 })).remark).toBe(
    'leading rest pose, left out',
  );
});

test('without keyposes it says so', () => {
  expect(captionOf(words, moment({ current: null })).title).toBe('No keyposes');
});
