import { expect, it } from 'vitest';
import { wordsFor } from './i18n/catalogue';
import { posture } from './posture';

const english = wordsFor('en');
const japanese = wordsFor('ja');

it('says one word, two, or nothing', () => {
  expect(posture(english, ['both-legs-high', 'left-arm-stretched'])).toBe(
    'both legs high, left arm stretched out',
  );
  expect(posture(japanese, ['both-legs-high', 'left-arm-stretched'])).toBe(
    '両脚を高く、左腕を伸ばして',
  );
  expect(posture(english, ['trunk-upright'])).toBe('upright');
  expect(posture(japanese, ['right-leg-forward'])).toBe('右脚を前に');
  expect(posture(english, [])).toBe('');
});
