/** The clips of the page in; how each runs along A out, as it is found; what is no longer wanted is cancelled. */
import { effect, signal, type ReadonlySignal } from '@preact/signals-core';
import type { Comparer, Warping } from '../engine/comparison-types';
import type { ClipId } from '../engine/types';
import type { PairClip } from './pair-clips';

export interface Warpings {
  /** By clip; A has none. */
  readonly found: ReadonlySignal<ReadonlyMap<ClipId, Warping>>;
  /** 0 to 1 while B is being warped, else null. */
  readonly progress: ReadonlySignal<number | null>;
  /** Why B could not be warped. */
  readonly failure: ReadonlySignal<unknown>;
  readonly destroy: () => void;
}

export interface WarpingWish {
  readonly clips: readonly PairClip[];
  readonly mirrorB: boolean;
}

const none: ReadonlyMap<ClipId, Warping> = new Map();

export function followWarpings(
  comparer: Pick<Comparer, 'warp'>,
  wish: ReadonlySignal<WarpingWish | null>,
): Warpings {
  const found = signal(none);
  const progress = signal<number | null>(null);
  const failure = signal<unknown>(null);
  const destroy = effect(() => {
    found.value = none;
    progress.value = failure.value = null;
    const wanted = wish.value;
    if (!wanted || wanted.clips.length < 2) return;
    const abort = new AbortController();
    void warpAll(comparer, wanted, { found, progress, failure }, abort.signal);
    return () => abort.abort();
  });
  return { found, progress, failure, destroy };
}

interface Told {
  readonly found: { value: ReadonlyMap<ClipId, Warping>; peek(): ReadonlyMap<ClipId, Warping> };
  readonly progress: { value: number | null };
  readonly failure: { value: unknown };
}

/** One after the other, B first. */
async function warpAll(
  comparer: Pick<Comparer, 'warp'>,
  { clips, mirrorB }: WarpingWish,
  told: Told,
  abort: AbortSignal,
): Promise<void> {
  const [a, ...others] = clips;
  for (const [i, other] of others.entries()) {
    const isB = i === 0;
    const tell = (done: number | null): void => {
      if (isB && !abort.aborted) told.progress.value = done;
    };
    tell(0);
    try {
      const settings = { band: null, mirrorB: isB && mirrorB };
      const work = { signal: abort, onProgress: ({ done }: { done: number }) => tell(done) };
      const warping = await comparer.warp(a.id, other.id, settings, work);
      if (abort.aborted) return;
      told.found.value = new Map([...told.found.peek(), [other.id, warping]]);
    } catch (error) {
      if (abort.aborted) return;
      if (isB) told.failure.value = error;
    }
    tell(null);
  }
}
