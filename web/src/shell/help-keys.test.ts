import { expect, test } from 'vitest';
import { wordsFor } from '../app/i18n/catalogue';
import { commandFor } from '../player/keys';
import { columns } from './help-keys';

const lines = columns.flat().flatMap(([, keys]) => keys);
const combinations = lines.flatMap(([, ...alternatives]) =>
  alternatives.map((one) => one.join(' ')),
);

test('the keys of the library are named', () => {
  for (const keys of [
    'F2',
    'key.ctrl A',
    'key.ctrl help.space',
    'key.shift ↑',
    'key.shift ↓',
    'key.delete',
  ])
    expect(combinations).toContain(keys);
});

test('no keys stand for two things, and every line has words in both languages', () => {
  expect(new Set(combinations).size).toBe(combinations.length);
  for (const language of ['en', 'ja'] as const) {
    const { t } = wordsFor(language);
    const labels = lines.map(([label]) => t(label));
    expect(new Set(labels).size, language).toBe(lines.length);
    expect(labels, language).not.toContain('');
    for (const [label] of lines) expect(t(label), language).not.toBe(label);
  }
});

test('every letter and sign that is named alone is a command', () => {
  const still = { shiftKey: false, ctrlKey: false, metaKey: false, altKey: false };
  const single = combinations.filter((keys) => /^[A-Z0-9[\]/?+-]$/.test(keys));
  expect(single.length).toBeGreaterThan(9);
  for (const key of single)
    expect(commandFor({ key: key.toLowerCase(), ...still }, 'page'), key).not.toBe(null);
});
