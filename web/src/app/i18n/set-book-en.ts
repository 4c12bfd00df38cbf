/** Compare and Pair in English. */
import type { Book, SetMessageKey } from './catalogue';
import { englishCompare } from './en-compare';
import { englishDistance } from './en-distance';
import { englishFilm } from './en-film';
import { englishMatrix } from './en-matrix';
import { englishPair } from './en-pair';
import type { Message } from './message';

const messages: Readonly<Record<SetMessageKey, Message>> = {
  ...englishCompare,
  ...englishDistance,
  ...englishFilm,
  ...englishMatrix,
  ...englishPair,
};

export const book = { messages, notes: {}, failures: {} } satisfies Book;
