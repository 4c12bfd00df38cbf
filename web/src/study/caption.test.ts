import { expect, test } from 'vitest';
import { wordsFor } from '../app/i18n/catalogue';
import { captionOf, type Moment } from './caption';

const moment = (fields: Partial<Moment>): Moment => ({
  frame: 338,
  frameTimeS: 1 / 120,
  keyposes: Int32Array.of(100, 338),
  current: 1,
  leadingRestFrames: 0,
  posture: '',
  performer: null,
  ...fields,
});
const words = wordsFor('en');

test('at a keypose it is named and spoken', () => {
  const caption = captionOf(words, moment({}));
  expect(caption).toEqual({
    title: 'Keypose 2 of 2',
    posture: '',
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

test('what it looks like is shown and spoken, with how far it is away', () => {
  const { posture, remark, spoken } = captionOf(
    words,
    moment({ frame: 345, posture: 'both legs high' }),
  );
  expect([posture, remark]).toEqual(['both legs high', '0.06 s past it']);
  expect(spoken).toBe('Keypose 2 of 2, 2.82 seconds, both legs high, 0.06 seconds past it');
});

test('of several performers the one is named', () => {
  const { title, spoken } = captionOf(words, moment({ performer: 'B' }));
  expect(title).toBe('B · Keypose 2 of 2');
  expect(spoken).toBe('Performer B, Keypose 2 of 2, 2.82 seconds');
});
