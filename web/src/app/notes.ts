/** Notes of a clip in; which of them ask for a look out. */
import type { ClipResult, Note } from '../engine/types';

/** Kinds that may have changed what is shown; the others only tell what was done as a matter of course. */
const warningKinds: ReadonlySet<string> = new Set([
  'alternating-rows',
  'channel-count',
  'discontinuity',
  'end-sites-unequal',
  'frame-count',
  'frame-time-invalid',
  'frame-time-is-milliseconds',
  'frame-time-is-rate',
  'frame-time-is-seconds',
  'frame-time-missing',
  'incomplete-last-row',
  'mirrored',
  'missing-brace',
  'missing-hierarchy',
  'missing-motion',
  'missing-offset',
  'no-left-and-right',
  'no-motion',
  'not-a-number',
  'offset-not-a-number',
  'relative-positions',
  'rest-is-no-body',
  'shifted-arm-names',
  'shifted-leg-names',
  'too-short',
  'unknown-line',
  'up-assumed',
]);

export const isWarning = ({ kind }: Note): boolean => warningKinds.has(kind);

/** The notes of the reading, then those of each performer; each one once. */
export function notesOf({ notes, performers }: ClipResult): readonly Note[] {
  const seen = new Set<string>();
  return [...notes, ...performers.flatMap((performer) => performer.notes)].filter((note) => {
    const key = JSON.stringify(note);
    return !seen.has(key) && seen.add(key);
  });
}

export const warningsAmong = (notes: readonly Note[]): number => notes.filter(isWarning).length;
