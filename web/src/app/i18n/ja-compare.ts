/** The sentences beside matrix and map in Japanese; the keys are those of `en-compare.ts`. */
import type { Message } from './catalogue';
import type { englishCompare } from './en-compare';

export const japaneseCompare: Readonly<Record<keyof typeof englishCompare, Message>> = {
  'library.label': 'ラベル：{0}',
};
