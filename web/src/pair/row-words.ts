/** The state of the pair page in; what its rows say out. */
import type { Synchronisation } from '../app/compare-store';
import { failureOf } from '../app/failure';
import type { Words } from '../app/i18n/catalogue';
import type { PairClip } from './pair-clips';
import type { PairState } from './pair-state';

/** How the clips run together: "warped". */
export function alignmentText({ t }: Words, way: Synchronisation, state: PairState): string {
  if (way !== 'warp') return t(`pair.alignment.${way}`);
  return t(state.warping.value ? 'pair.alignment.warp' : 'pair.alignment.start');
}

type WarpingState = Pick<PairState, 'warping' | 'clips'> & {
  readonly warpings: Pick<PairState['warpings'], 'failure' | 'cancelled' | 'progress'>;
};

/** Why there is no path yet; empty when there is one. */
export function warpingText({ t, format, failure }: Words, state: WarpingState): string {
  const { failure: why, cancelled, progress } = state.warpings;
  if (state.warping.value) return '';
  if (why.value !== null) {
    const { kind, details } = failureOf(why.value);
    const two = state.clips.value.slice(0, 2);
    const frames = two.map((clip) => format.integer(clip.frames));
    if (two.some(({ performer }) => performer.body.kind !== 'human')) return t('pair.not-compared');
    if (kind === 'setting' && details[0] === 'band') return t('pair.warp.too-long', ...frames);
    return t('pair.warp.failed', failure(failureOf(why.value)));
  }
  if (cancelled.value) return t('pair.warp.cancelled');
  return t('pair.warp.progress', format.integer(Math.floor(100 * (progress.value ?? 0))));
}

/** The motion speed at a frame; null where none is known. */
export function speedAt({ performer: { keyposes } }: PairClip, frame: number): number | null {
  return keyposes?.speed[frame - keyposes.firstFrame] ?? null;
}
