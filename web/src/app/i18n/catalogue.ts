/**
 * A language in; its words out: sentences by key, notes and errors by kind, numbers by the rules of
 * the language. `{0}`, `{1}` … stand for the arguments; a message with two forms takes the form of its
 * first number.
 */
import type { Failure, Note } from '../../engine/types';
import { createFormat, type Format } from '../format';
import type { en } from './en';
import type { englishCompare } from './en-compare';
import type { englishDistance } from './en-distance';
import type { englishFilm } from './en-film';
import type { englishMatrix } from './en-matrix';
import type { englishPair } from './en-pair';
import type { Message } from './message';

/** Sentences that come with Compare and Pair. */
export type SetMessageKey =
  | keyof typeof englishCompare
  | keyof typeof englishDistance
  | keyof typeof englishFilm
  | keyof typeof englishMatrix
  | keyof typeof englishPair;

export type MessageKey = keyof typeof en | SetMessageKey;
export type Language = 'en' | 'ja';
export type Argument = string | number;

export interface Words {
  readonly language: Language;
  readonly format: Format;
  /** The sentence of a key. */
  readonly t: (key: MessageKey, ...values: readonly Argument[]) => string;
  /** The sentence of a note of the reader or the analysis. */
  readonly note: (note: Note) => string;
  /** The same in two: what was found, and what was made of it ('' where the sentence is one). */
  readonly noteParts: (note: Note) => { readonly what: string; readonly assumed: string };
  /** The sentence of a failure. */
  readonly failure: (failure: Failure) => string;
}

/** Words of one language, or of a part of the app in it. */
export interface Book {
  readonly messages: Readonly<Partial<Record<MessageKey, Message>>>;
  readonly notes: Readonly<Record<string, string>>;
  readonly failures: Readonly<Record<string, string>>;
}

const nothing: Book = { messages: {}, notes: {}, failures: {} };

const books: Record<Language, Book> = { en: nothing, ja: nothing };

/** Until its words are there, a key stands for itself. */
export function addWords(language: Language, more: Book): void {
  const { messages, notes, failures } = books[language];
  books[language] = {
    messages: { ...messages, ...more.messages },
    notes: { ...notes, ...more.notes },
    failures: { ...failures, ...more.failures },
  };
}

/** Puts the values in the places `{0}`, `{1}` … of a template. */
export function fill(template: string, values: readonly string[]): string {
  return template.replace(/\{(\d+)\}/g, (place, index: string) => values[Number(index)] ?? place);
}

/** Where a note turns from what was found to what was made of it. */
const turns: Readonly<Record<Language, RegExp>> = { en: /; /, ja: /。(?=.)/ };

const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

/** The first part stands as a title, without a full stop. */
function splitNote(template: string, language: Language): { what: string; assumed: string } {
  const at = turns[language].exec(template);
  const what = at ? template.slice(0, at.index) : template;
  const assumed = at ? template.slice(at.index + at[0].length) : '';
  return { what: what.replace(/[.。]$/, ''), assumed: capital(assumed) };
}

export function wordsFor(language: Language): Words {
  const plural = new Intl.PluralRules(language);
  const format = createFormat(language);

  const form = (message: Message, values: readonly Argument[]): string => {
    if (typeof message === 'string') return message;
    const count = values.find((value) => typeof value === 'number') ?? 0;
    return plural.select(Number(count)) === 'one' ? message.one : message.other;
  };
  const text = (value: Argument): string =>
    typeof value === 'number' ? format.integer(value) : value;
  const template = ({ kind, details }: Pick<Note, 'kind' | 'details'>): string =>
    books[language].notes[kind] ?? [kind, ...details].join(' ');

  return {
    language,
    format,
    t: (key, ...values) =>
      fill(form(books[language].messages[key] ?? key, values), values.map(text)),
    note: (note) => fill(template(note), note.details),
    noteParts: (note) => {
      const { what, assumed } = splitNote(template(note), language);
      return { what: fill(what, note.details), assumed: fill(assumed, note.details) };
    },
    // Why a clip has no keyposes is told as a failure, in the words of the note.
    failure: (failure) =>
      fill(books[language].failures[failure.kind] ?? template(failure), failure.details),
  };
}
