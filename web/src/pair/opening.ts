/** The clips of the page before and now in; where A's time begins out. Pure. */
import type { PairClip } from './pair-clips';

type Opened = Pick<PairClip, 'id' | 'keyposes' | 'frames' | 'frameTimeS'> & {
  readonly performer: Pick<PairClip['performer'], 'leadingRestFrames'>;
};

/** Its first keypose; without one, where the rest before the motion has ended. */
export function openingFrame({ keyposes, performer, frames }: Opened): number {
  return keyposes[0] ?? Math.min(performer.leadingRestFrames, frames - 1);
}

export interface Before {
  readonly clips: readonly Opened[];
  /** The moments of the clips, in frames. */
  readonly frameOf: (place: number) => number;
  readonly timeOf: (place: number) => number;
}

/**
 * Seconds of A. A clip that comes to be A goes on where it was, on this page or in the study; one at
 * whose time nobody has touched is at its opening, also when that comes to be known later.
 */
export function startOfA(a: Opened, before: Before, studiedFrame: number): number {
  const place = before.clips.findIndex(({ id }) => id === a.id);
  const frame = place < 0 ? studiedFrame : before.frameOf(place);
  const untouched = place < 0 ? 0 : place === 0 ? openingFrame(before.clips[0]) : -1;
  if (frame === untouched) return openingFrame(a) * a.frameTimeS;
  return place < 0 ? studiedFrame * a.frameTimeS : before.timeOf(place);
}
