/** What a keypose looks like: the core's words in, one phrase of the language out; '' without words. */
import type { PostureWord } from '../engine/types';
import type { Words } from './i18n/catalogue';

export function posture({ t }: Words, list: readonly PostureWord[]): string {
  const phrases = list.map((word) => t(`posture.${word}`));
  return phrases.length === 0 ? '' : phrases.reduce((all, one) => t('posture.join', all, one));
}
