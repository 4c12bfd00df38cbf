/** What the page explains at a moment: the current keypose, or the candidate that a person went to by intensity. */
import type { KeyposeResult } from '../engine/types';

export interface WhySubject {
  /** Index into `candidates`. */
  readonly candidate: number;
  /** Index into `keyposes`; null for a candidate that is none. */
  readonly keypose: number | null;
  /** From 1, the most intense; null while it is not known. */
  readonly rank: number | null;
  /** Candidates next to it in order of intensity. */
  readonly stronger: number | null;
  readonly weaker: number | null;
}

const found = (index: number): number | null => (index < 0 ? null : index);

function subjectOf(result: KeyposeResult, candidate: number): WhySubject {
  const { byIntensity, intensities, keyposes } = result;
  const place = byIntensity.indexOf(candidate);
  const weaker = place < 0 ? undefined : byIntensity[place + 1];
  // Candidates of zero intensity have nothing to show.
  const hasWeight = weaker !== undefined && (intensities[weaker] ?? 0) > 0;
  return {
    candidate,
    keypose: found(keyposes.indexOf(candidate)),
    rank: place < 0 ? null : place + 1,
    stronger: place > 0 ? (byIntensity[place - 1] ?? null) : null,
    weaker: hasWeight ? weaker : null,
  };
}

/** `goneTo`: the candidate gone to, as long as the playhead is still on its frame. */
export function whySubject(
  result: KeyposeResult,
  currentKeypose: number | null,
  goneTo: number | null,
): WhySubject | null {
  const current = currentKeypose === null ? undefined : result.keyposes[currentKeypose];
  const candidate = goneTo ?? current;
  return candidate === undefined ? null : subjectOf(result, candidate);
}
