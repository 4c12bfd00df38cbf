/** Compare and Pair in English. */
import type { Book, Message, SetMessageKey } from './catalogue';
import { englishCompare } from './en-compare';
import { englishDistance } from './en-distance';
import { englishMatrix } from './en-matrix';
import { englishPair } from './en-pair';

const messages: Readonly<Record<SetMessageKey, Message>> = {
  ...englishCompare,
  ...englishDistance,
  ...englishMatrix,
  ...englishPair,
};

export const book = { messages, notes: {}, failures: {} } satisfies Book;
