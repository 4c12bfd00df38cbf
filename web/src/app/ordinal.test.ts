import { expect, test } from 'vitest';
import { wordsFor } from './i18n/catalogue';
import { ordinal } from './ordinal';

test('places in English have their endings', () => {
  const english = wordsFor('en');
  const places = [1, 2, 3, 4, 11, 22, 298, 1003];
  expect(places.map((place) => ordinal(english, place))).toEqual([
    '1st',
    '2nd',
    '3rd',
    '4th',
    '11th',
    '22nd',
    '298th',
    '1,003rd',
  ]);
});

test('places in Japanese are counted', () => {
  expect(ordinal(wordsFor('ja'), 3)).toBe('3 番目');
});
