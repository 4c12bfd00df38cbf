/** The selection and the library in; the clips of the pair page that are read out, A first, then B. */
import { computed, type ReadonlySignal } from '@preact/signals-core';
import { keyposeFrames, type Clip } from '../app/clips';
import type { Store } from '../app/store';
import type { ClipId, ClipResult, PerformerResult } from '../engine/types';
import { performerLetter } from '../figure/performer-letter';

export interface PairClip {
  readonly id: ClipId;
  /** A, B, C … */
  readonly letter: string;
  /** File name without its ending. */
  readonly name: string;
  readonly frames: number;
  readonly frameTimeS: number;
  readonly result: ClipResult;
  /** The performer shown: the first human one, else the first. */
  readonly performerIndex: number;
  readonly performer: PerformerResult;
  /** Frames of its keyposes, ascending. */
  readonly keyposes: Int32Array;
}

export const shortName = (name: string): string => name.replace(/\.bvh$/i, '');

/** The clips selected for the page, in order, whether they are read or not. */
export function selectedIds({ openId, compare }: Store): ClipId[] {
  const ids = [openId.value, compare.otherId.value, ...compare.alsoIds.value];
  return [...new Set(ids)].filter((id) => id !== null);
}

export function followPairClips(store: Store): ReadonlySignal<readonly PairClip[]> {
  let before: readonly PairClip[] = [];
  return computed(() => {
    const clips = store.clips.value;
    const ids = selectedIds(store).filter((id) => clips[id] && !clips[id].removed);
    // Letters are those of the selection: B stays B while A is still being read.
    const now = ids.flatMap((id, place) => pairClip(clips[id], place) ?? []);
    const same = now.length === before.length && now.every((clip, i) => isSame(clip, before[i]));
    if (!same) before = now;
    return before;
  });
}

function pairClip({ id, source, result }: Clip, place: number): PairClip | null {
  if (!result || result.performers.length === 0) return null;
  const human = result.performers.findIndex(({ body }) => body.kind === 'human');
  const performerIndex = Math.max(0, human);
  const performer = result.performers[performerIndex];
  return {
    id,
    letter: performerLetter(place),
    name: shortName(source.name),
    frames: Math.max(1, result.frames),
    frameTimeS: result.frameTimeS,
    result,
    performerIndex,
    performer,
    keyposes: keyposeFrames(performer),
  };
}

const isSame = (a: PairClip, b: PairClip | undefined): boolean =>
  a.id === b?.id && a.letter === b.letter && a.result === b.result;
