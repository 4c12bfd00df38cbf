/** The study and the page around it in English. */
import type { Book } from './catalogue';
import { en } from './en';
import { englishFailures, englishNotes } from './en-notes';

export const book: Book = { messages: en, notes: englishNotes, failures: englishFailures };
