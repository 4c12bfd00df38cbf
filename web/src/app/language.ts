/** The language: what the person chose, else the first of the browser's languages that the page speaks. */
import { computed, signal, type ReadonlySignal } from '@preact/signals-core';
import { wordsFor, type Language, type Words } from './i18n/catalogue';
import type { Preferences } from './preferences';

export interface LanguageState {
  readonly words: ReadonlySignal<Words>;
  readonly choose: (language: Language) => void;
}

const languages: readonly Language[] = ['en', 'ja'];

export function spokenLanguage(stored: string | null, wanted: readonly string[]): Language {
  const chosen = languages.find((language) => language === stored);
  const first = wanted.map((tag) =>
    languages.find((language) => tag.toLowerCase().startsWith(language)),
  );
  return chosen ?? first.find((language) => language !== undefined) ?? 'en';
}

export function createLanguage(preferences: Preferences, wanted: readonly string[]): LanguageState {
  const language = signal(spokenLanguage(preferences.get('language'), wanted));
  return {
    words: computed(() => wordsFor(language.value)),
    choose(next) {
      language.value = next;
      preferences.set('language', next);
    },
  };
}
