import { expect, test } from 'vitest';
import { fitText } from './fit-text';

const widthOf = (text: string): number => 10 * Array.from(text).length;

test('what has room stays; else the end gives way to an ellipsis', () => {
  expect(fitText('07_11', 50, widthOf)).toBe('07_11');
  expect(fitText('07_11_walk', 60, widthOf)).toBe('07_11…');
  expect(fitText('a walk', 30, widthOf)).toBe('a…');
  expect(fitText('walk', 5, widthOf)).toBe('');
});

test('letters of more than one code stay whole', () => {
  expect(fitText('𠮷野家で歩く', 30, widthOf)).toBe('𠮷野…');
});
