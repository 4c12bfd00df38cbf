/** The selection and the library in; the clips of the pair page out, A first, then B, as far as they are read. */
import { computed, type ReadonlySignal } from '@preact/signals-core';
import { keyposeFrames, type Clip } from '../app/clips';
import type { Store } from '../app/store';
import type { ClipId, ClipResult, PerformerResult } from '../engine/types';
import { performerLetter } from '../figure/performer-letter';

export interface PairClip {
  readonly id: ClipId;
  /** Among the clips of the page, from 0. */
  readonly place: number;
  /** A, B, C … */
  readonly letter: string;
  /** File name without its ending. */
  readonly name: string;
  /** What tells it from clips of the same name; empty where there are none. */
  readonly qualifier: string;
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
    // Elsewhere nothing is fetched for this page.
    const ids = store.compare.page.value === 'pair' ? selectedIds(store) : [];
    const present = ids.filter((id) => clips[id] && !clips[id].removed);
    const qualifiers = store.qualifiers.value;
    const all = present.map((id, place) => pairClip(clips[id], place, qualifiers.get(id) ?? ''));
    const unread = all.indexOf(null);
    const now = (unread < 0 ? all : all.slice(0, unread)).filter((clip) => clip !== null);
    const same = now.length === before.length && now.every((clip, i) => isSame(clip, before[i]));
    if (!same) before = now;
    return before;
  });
}

function pairClip({ id, source, result }: Clip, place: number, qualifier: string): PairClip | null {
  if (!result || result.performers.length === 0) return null;
  const human = result.performers.findIndex(({ body }) => body.kind === 'human');
  const performerIndex = Math.max(0, human);
  const performer = result.performers[performerIndex];
  return {
    id,
    place,
    letter: performerLetter(place),
    name: shortName(source.name),
    qualifier,
    frames: Math.max(1, result.frames),
    frameTimeS: result.frameTimeS,
    result,
    performerIndex,
    performer,
    keyposes: keyposeFrames(performer),
  };
}

const isSame = (a: PairClip, b: PairClip | undefined): boolean =>
  a.id === b?.id && a.place === b.place && a.result === b.result && a.qualifier === b.qualifier;
