/** The sentences of Compare and Pair in both languages, which come with these pages. */
import type { Language, Message, SetMessageKey } from './catalogue';
import { englishCompare } from './en-compare';
import { englishDistance } from './en-distance';
import { englishMatrix } from './en-matrix';
import { englishPair } from './en-pair';
import { japaneseCompare } from './ja-compare';
import { japaneseDistance } from './ja-distance';
import { japaneseMatrix } from './ja-matrix';
import { japanesePair } from './ja-pair';

export const setWords: Readonly<Record<Language, Readonly<Record<SetMessageKey, Message>>>> = {
  en: { ...englishCompare, ...englishDistance, ...englishMatrix, ...englishPair },
  ja: { ...japaneseCompare, ...japaneseDistance, ...japaneseMatrix, ...japanesePair },
};
