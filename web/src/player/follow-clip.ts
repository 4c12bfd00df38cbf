/** The open clip of the store in; its clock running out. A new rate keeps the frame; a new clip starts at 0. */
import { effect } from '@preact/signals-core';
import type { ClipId, Engine } from '../engine/types';
import type { Store } from '../app/store';
import type { Playback } from './playback';

const emptyClip = { frames: 1, frameTimeS: 1 };

export function followOpenClip(
  store: Store,
  playback: Playback,
  engine: Pick<Engine, 'keep'>,
): () => void {
  let shownId: ClipId | null = null;
  return effect(() => {
    const clip = store.openClip.value;
    const result = clip?.result ?? emptyClip;
    const id = clip?.result ? clip.id : null;
    engine.keep(clip?.id ?? null);
    const { frames, frameTimeS, frame } = playback.clock;
    if (id !== shownId) {
      playback.load(result, 0);
    } else if (frames !== result.frames || frameTimeS !== result.frameTimeS) {
      playback.load(result, frame);
    }
    shownId = id;
  });
}
