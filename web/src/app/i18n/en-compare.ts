/** The sentences beside matrix and map in English: labels, evaluation, why, neighbours, table. */
import type { Message } from './catalogue';

export const englishCompare = {
  'library.label': 'Label: {0}',
} satisfies Readonly<Record<string, Message>>;
