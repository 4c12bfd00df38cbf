import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { ENGINE_FAILURES } from '../../engine/failures';
import { fill, wordsFor } from './catalogue';
import { en as studyWords } from './en';
import { englishFailures, englishNotes } from './en-notes';
import { ja as studyWordsJa } from './ja';
import { japaneseFailures, japaneseNotes } from './ja-notes';
import type { Message } from './message';
import { book as setWords } from './set-book-en';
import { book as setWordsJa } from './set-book-ja';

const en = { ...studyWords, ...setWords.messages };
const ja = { ...studyWordsJa, ...setWordsJa.messages };

const places = (text: string): string[] => [...new Set(text.match(/\{\d\}/g) ?? [])].sort();
const forms = (message: Message): string[] =>
  typeof message === 'string' ? [message] : [message.one, message.other];

/** Kinds and sentences as the core's macro lists them. */
function coreSentences(file: string): Record<string, string> {
  const source = readFileSync(
    new URL(`../../../../crates/motion/src/${file}`, import.meta.url),
    'utf8',
  );
  const lines = source.matchAll(/^ {4}\w+ "([\w-]+)" "((?:[^"\\]|\\.)*)";/gm);
  return Object.fromEntries([...lines].map(([, kind, text]) => [kind, text]));
}

test('Japanese has every key of English, and no other', () => {
  expect(Object.keys(ja).sort()).toEqual(Object.keys(en).sort());
});

test('both languages name the same places', () => {
  for (const [key, message] of Object.entries(en)) {
    const wanted = places(forms(message).join(''));
    expect(places(forms(ja[key as keyof typeof en]).join('')), key).toEqual(wanted);
  }
});

/** Signs, units, keys and the product's name. */
const sameInBoth = [
  /^method\.source$/,
  /^unit\.(seconds|hertz|hz|percent|s|m|dm|cm|mm|cmu)$/,
  /^key\./,
  /^top\.(place|bar)$/,
  /^caption\.performer$/,
  /^transport\.(last|times|ab|range)$/,
  /^evaluation\.r-p$/,
  /^table\.[ab]$/,
];

test('what reads the same in both languages does so on purpose', () => {
  const same = Object.entries(en).filter(
    ([key, message]) => JSON.stringify(message) === JSON.stringify(ja[key as keyof typeof en]),
  );
  const unintended = same.filter(([key]) => !sameInBoth.some((known) => known.test(key)));
  expect(unintended).toEqual([]);
});

test('no sentence is empty', () => {
  for (const book of [en, ja, englishNotes, englishFailures, japaneseNotes, japaneseFailures]) {
    for (const message of Object.values(book)) {
      expect(forms(message).every((text) => text.trim() !== '')).toBe(true);
    }
  }
});

test('notes are those of the core, word for word', () => {
  expect(englishNotes).toEqual(coreSentences('note.rs'));
});

test('reading failures are those of the core, word for word', () => {
  expect(englishFailures).toMatchObject(coreSentences('bvh/error.rs'));
});

test('every failure of the engine has a sentence', () => {
  for (const kind of ENGINE_FAILURES) expect(englishFailures, kind).toHaveProperty([kind]);
});

test('Japanese tells every note and failure, with the same places', () => {
  for (const [english, japanese] of [
    [englishNotes, japaneseNotes],
    [englishFailures, japaneseFailures],
  ] as const) {
    expect(Object.keys(japanese).sort()).toEqual(Object.keys(english).sort());
    for (const [kind, text] of Object.entries(english)) {
      expect(places(japanese[kind]), kind).toEqual(places(text));
    }
  }
});

test('what a detail holds stays as it is', () => {
  expect(fill('{0} before {1}', ['{1}', 'x'])).toBe('{1} before x');
});

test('the form goes by the first number', () => {
  const { t } = wordsFor('en');
  expect(t('library.count', 1)).toBe('1 clip');
  expect(t('library.count', 1200)).toBe('1,200 clips');
  expect(wordsFor('ja').t('library.count', 2)).toBe('2 件');
});

test('an unknown kind shows itself', () => {
  const failure = { kind: 'brand-new', line: null, column: null, details: ['x'] };
  expect(wordsFor('en').failure(failure)).toBe('brand-new x');
});

test('a note falls into what was found and what was made of it', () => {
  const note = (kind: string, ...details: string[]) => ({
    kind,
    line: 3,
    column: 1,
    frame: null,
    details,
  });
  const english = wordsFor('en');
  const comma = note('unknown-line', 'a; b');
  expect(english.noteParts(note('missing-offset', 'Hips'))).toEqual({
    what: 'Hips has no OFFSET',
    assumed: 'Zero was assumed.',
  });
  expect(english.noteParts(comma).what).toBe('A line was not understood and ignored: a; b');
  expect(wordsFor('ja').noteParts(note('missing-offset', 'Hips'))).toEqual({
    what: 'Hips に OFFSET がありません',
    assumed: 'ゼロとしました。',
  });
});
