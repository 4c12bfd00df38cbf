/** Clips in; those that cannot be compared, each with its reason, out. */
import type { Clip } from '../app/clips';
import type { MessageKey } from '../app/i18n/catalogue';

export interface Apart {
  readonly clip: Clip;
  readonly reason: MessageKey;
}

function reasonOf({ result }: Clip): MessageKey | null {
  if (!result || result.performers.some(({ feature }) => feature !== null)) return null;
  if (result.frames === 0) return 'compare.apart.skeleton';
  if (result.frames === 1) return 'compare.apart.pose';
  const human = result.performers.some(({ body }) => body.kind === 'human');
  return human ? 'compare.apart.unknown' : 'compare.apart.not-human';
}

/** What could not be read has its reason in the library. */
export function clipsApart(clips: readonly Clip[]): readonly Apart[] {
  return clips.flatMap((clip) => {
    const reason = clip.status === 'ready' ? reasonOf(clip) : null;
    return reason ? [{ clip, reason }] : [];
  });
}
