/** How long work has taken and how much of it is done in; how long the rest will take out, also in words. */
import type { Words } from './i18n/catalogue';

/** Too early, an estimate leaps about. */
const leastElapsedS = 0.7;
const leastFraction = 0.02;

export function estimateSecondsLeft(elapsedS: number, done: number, total: number): number | null {
  const fraction = total > 0 ? done / total : 0;
  if (elapsedS < leastElapsedS || fraction < leastFraction) return null;
  return (elapsedS * (1 - fraction)) / fraction;
}

/** Nothing while nobody can tell. */
export function timeLeftText({ t, format }: Words, leftS: number | null): string {
  if (leftS === null) return '';
  return leftS < 90
    ? t('progress.left.seconds', format.integer(Math.max(1, Math.ceil(leftS))))
    : t('progress.left.minutes', format.integer(Math.ceil(leftS / 60)));
}
