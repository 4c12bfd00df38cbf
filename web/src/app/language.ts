/**
 * The language: what the person chose, else the first of the browser's languages that the page speaks.
 * Its words are fetched; the page turns to a language when all are there, so that none is seen half.
 */
import { computed, signal, type ReadonlySignal } from '@preact/signals-core';
import { wordsFor, type Language, type Words } from './i18n/catalogue';
import { loadWords, type Part } from './i18n/load-words';
import type { Preferences } from './preferences';

export interface LanguageState {
  readonly words: ReadonlySignal<Words>;
  /** Rejects where the words cannot be fetched; the page then stays as it is. */
  readonly choose: (language: Language) => Promise<void>;
  /** Fetches the words of a part of the app, and from now on those of every language chosen. */
  readonly need: (part: Part) => Promise<void>;
}

const languages: readonly Language[] = ['en', 'ja'];

export function spokenLanguage(stored: string | null, wanted: readonly string[]): Language {
  const chosen = languages.find((language) => language === stored);
  const first = wanted.map((tag) =>
    languages.find((language) => tag.toLowerCase().startsWith(language)),
  );
  return chosen ?? first.find((language) => language !== undefined) ?? 'en';
}

/** The words that have been asked for, each fetched once. */
class Shelf {
  private readonly parts = new Set<Part>();
  private readonly here = new Set<string>();

  constructor(private readonly load: typeof loadWords) {}

  add(part: Part): void {
    this.parts.add(part);
  }

  /** Until nothing is missing: a part may be added meanwhile. */
  async fill(language: Language): Promise<void> {
    const missing = [...this.parts].filter((part) => !this.here.has(language + part));
    if (missing.length === 0) return;
    await Promise.all(
      missing.map(async (part) => {
        await this.load(language, part);
        this.here.add(language + part);
      }),
    );
    await this.fill(language);
  }
}

export function createLanguage(
  preferences: Preferences,
  wanted: readonly string[],
  load = loadWords,
): LanguageState {
  const language = signal(spokenLanguage(preferences.get('language'), wanted));
  const shelf = new Shelf(load);
  let asked = language.value;
  return {
    words: computed(() => wordsFor(language.value)),
    async choose(next) {
      asked = next;
      await shelf.fill(next);
      if (asked !== next) return;
      language.value = next;
      preferences.set('language', next);
    },
    async need(part) {
      shelf.add(part);
      await shelf.fill(language.value);
    },
  };
}
