/** How long work has taken and how much of it is done in; the seconds that the rest will take out. */

/** Too early, an estimate leaps about. */
const leastElapsedS = 0.7;
const leastFraction = 0.02;

export function estimateSecondsLeft(elapsedS: number, done: number, total: number): number | null {
  const fraction = total > 0 ? done / total : 0;
  if (elapsedS < leastElapsedS || fraction < leastFraction) return null;
  return (elapsedS * (1 - fraction)) / fraction;
}
