/** Superposed clips and the moments at which they meet in; where each stands out, as soon as their poses are here. */
import { effect, signal, type ReadonlySignal } from '@preact/signals-core';
import type { Engine } from '../engine/types';
import type { Placement } from '../figure/placement';
import type { PairClip } from './pair-clips';
import { standTogether } from './stands';

export interface Meeting {
  readonly clips: readonly PairClip[];
  /** The frame of each clip. */
  readonly frames: readonly number[];
  readonly mirrorB: boolean;
}

export function followMeeting(
  engine: Pick<Engine, 'poses'>,
  meeting: ReadonlySignal<Meeting | null>,
): ReadonlySignal<readonly Placement[] | null> {
  const placements = signal<readonly Placement[] | null>(null);
  effect(() => {
    const wanted = meeting.value;
    if (!wanted || wanted.clips.length === 0) return;
    const abort = new AbortController();
    const { clips, frames, mirrorB } = wanted;
    const poses = clips.map(({ id, performerIndex }, place) =>
      engine.poses(id, performerIndex, Int32Array.of(frames[place]), { signal: abort.signal }),
    );
    Promise.all(poses).then(
      (all) => {
        if (abort.signal.aborted) return;
        placements.value = clips.map((clip, place) =>
          standTogether(clips[0], clip, all[0], all[place], mirrorB && place === 1),
        );
      },
      // A clip that has gone says so itself.
      () => undefined,
    );
    return () => abort.abort();
  });
  return placements;
}
