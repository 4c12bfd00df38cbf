/** Clips in; those that cannot be compared, each with its reason, out. */
import type { Clip } from '../app/clips';
import type { MessageKey } from '../app/i18n/catalogue';

export interface Apart {
  readonly clip: Clip;
  readonly reason: MessageKey;
}

/** Known as soon as a clip of many has been read, before its keyposes are. */
function reasonOf({ incomparable, extent }: Clip): MessageKey | null {
  if (!incomparable) return null;
  if (extent?.frames === 0) return 'compare.apart.skeleton';
  if (extent?.frames === 1) return 'compare.apart.pose';
  const human = incomparable.kind !== 'not-human-to-compare';
  return human ? 'compare.apart.unknown' : 'compare.apart.not-human';
}

/** What could not be read has its reason in the library. */
export function clipsApart(clips: readonly Clip[]): readonly Apart[] {
  return clips.flatMap((clip) => {
    const reason = clip.status === 'failed' ? null : reasonOf(clip);
    return reason ? [{ clip, reason }] : [];
  });
}
