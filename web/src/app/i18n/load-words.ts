/** A language and a part of the app in; its words in the catalogue out: each is fetched when it is asked for. */
import { addWords, type Book, type Language } from './catalogue';

/** `page`: the study and all around it; `sets`: Compare and Pair. */
export type Part = 'page' | 'sets';

const sources: Readonly<Record<Part, Readonly<Record<Language, () => Promise<{ book: Book }>>>>> = {
  page: { en: () => import('./book-en'), ja: () => import('./book-ja') },
  sets: { en: () => import('./set-book-en'), ja: () => import('./set-book-ja') },
};

export async function loadWords(language: Language, part: Part): Promise<void> {
  addWords(language, (await sources[part][language]()).book);
}
