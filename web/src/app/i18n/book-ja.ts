/** The study and the page around it in Japanese. */
import type { Book } from './catalogue';
import { ja } from './ja';
import { japaneseFailures, japaneseNotes } from './ja-notes';

export const book: Book = { messages: ja, notes: japaneseNotes, failures: japaneseFailures };
