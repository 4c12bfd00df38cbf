import { expect, test, vi } from 'vitest';
import { createLanguage, spokenLanguage } from './language';
import type { loadWords } from './i18n/load-words';

const forgetful = { get: () => null, set: vi.fn() };

/** Words that come when the test says so. */
function withSlowWords(wanted: string) {
  const asked: string[] = [];
  const arrivals = new Map<string, { come: () => void; fail: (error: Error) => void }>();
  const load: typeof loadWords = (language, part) => {
    asked.push(`${language} ${part}`);
    return new Promise((come, fail) => arrivals.set(`${language} ${part}`, { come, fail }));
  };
  const arrive = async (name: string): Promise<void> => {
    arrivals.get(name)?.come();
    await new Promise((done) => setTimeout(done));
  };
  return { language: createLanguage(forgetful, [wanted], load), asked, arrive, arrivals };
}

test('what was chosen comes first, then the first language that is spoken, then English', () => {
  expect(spokenLanguage('ja', ['en-GB'])).toBe('ja');
  expect(spokenLanguage(null, ['fr', 'ja-JP', 'en'])).toBe('ja');
  expect(spokenLanguage('fr', ['de'])).toBe('en');
});

test('only the words of the language shown are fetched', async () => {
  const { language, asked, arrive } = withSlowWords('ja-JP');
  const ready = language.need('page');
  await arrive('ja page');
  await ready;
  expect(asked).toEqual(['ja page']);
});

test('the page turns to a language when its words are there, and not before', async () => {
  const { language, arrive } = withSlowWords('en');
  const ready = language.need('page');
  await arrive('en page');
  await ready;
  const turned = language.choose('ja');
  expect(language.words.value.language).toBe('en');
  await arrive('ja page');
  await turned;
  expect(language.words.value.language).toBe('ja');
});

test('a part asked for while another language comes is waited for in that language too', async () => {
  const { language, arrive, asked } = withSlowWords('en');
  void language.need('page');
  await arrive('en page');
  const turned = language.choose('ja');
  void language.need('sets');
  await arrive('ja page');
  expect(language.words.value.language).toBe('en');
  expect(asked).toContain('ja sets');
  await arrive('ja sets');
  await turned;
  expect(language.words.value.language).toBe('ja');
});

test('of two choices the later one holds', async () => {
  const { language, arrive } = withSlowWords('en');
  void language.need('page');
  await arrive('en page');
  const first = language.choose('ja');
  await language.choose('en');
  await arrive('ja page');
  await first;
  expect(language.words.value.language).toBe('en');
});

test('words that cannot be fetched leave the language as it is, and are asked for again', async () => {
  const { language, arrive, arrivals } = withSlowWords('en');
  void language.need('page');
  await arrive('en page');
  const turned = language.choose('ja');
  arrivals.get('ja page')?.fail(new Error('no network'));
  await expect(turned).rejects.toThrow('no network');
  expect(language.words.value.language).toBe('en');
  const again = language.choose('ja');
  await arrive('ja page');
  await again;
  expect(language.words.value.language).toBe('ja');
});
