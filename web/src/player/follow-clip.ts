/**
 * The open clip of the store in; its clock running out. A new rate keeps the frame and the loop; a clip
 * that comes back, as when its removal is undone, is where it was left.
 */
import { effect } from '@preact/signals-core';
import type { ClipId, Engine } from '../engine/types';
import type { Store } from '../app/store';
import type { Place, Playback } from './playback';

const emptyClip = { frames: 1, frameTimeS: 1 };
const start: Place = { frame: 0, loop: null };

export function followOpenClip(
  store: Store,
  playback: Playback,
  engine: Pick<Engine, 'keep'>,
): () => void {
  let shownId: ClipId | null = null;
  const left = new Map<ClipId, Place>();
  return effect(() => {
    const clip = store.openClip.value;
    const result = clip?.result ?? emptyClip;
    const id = clip?.result ? clip.id : null;
    engine.keep(clip?.id ?? null);
    const { frames, frameTimeS, frame, loopRange: loop } = playback.clock;
    if (id !== shownId) {
      if (shownId !== null) left.set(shownId, { frame, loop });
      playback.load(result, (id === null ? undefined : left.get(id)) ?? start);
    } else if (frames !== result.frames || frameTimeS !== result.frameTimeS) {
      playback.load(result, { frame, loop });
    }
    shownId = id;
  });
}
