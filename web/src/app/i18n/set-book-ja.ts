/** Compare and Pair in Japanese. */
import type { Book, SetMessageKey } from './catalogue';
import { japaneseCompare } from './ja-compare';
import { japaneseDistance } from './ja-distance';
import { japaneseFilm } from './ja-film';
import { japaneseMatrix } from './ja-matrix';
import { japanesePair } from './ja-pair';
import type { Message } from './message';

const messages: Readonly<Record<SetMessageKey, Message>> = {
  ...japaneseCompare,
  ...japaneseDistance,
  ...japaneseFilm,
  ...japaneseMatrix,
  ...japanesePair,
};

export const book = { messages, notes: {}, failures: {} } satisfies Book;
