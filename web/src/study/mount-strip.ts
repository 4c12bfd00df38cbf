/** The keypose strip on the page: there while a clip with a motion is open. */
import { computed, signal } from '@preact/signals-core';
import type { Context } from '../app/context';
import { keep } from '../common/keep';
import { follow } from '../common/mount';
import type { PerformerResult } from '../engine/types';
import { KeyposeStrip, type StripProps } from '../strip/keypose-strip';
import { stripText } from './study-text';

interface StripPoses {
  readonly performer: PerformerResult;
  readonly poses: Float32Array;
}

export function mountStrip(
  place: HTMLElement,
  { engine, store, playback, language }: Context,
): void {
  const text = computed(() => stripText(language.words.value));
  const loaded = signal<StripPoses | null>(null);
  const pick = (keypose: number): void => playback.seek(store.keyposeFrames.peek()[keypose] ?? 0);
  const show = keep<StripProps>((props) => new KeyposeStrip(place, props, { onPick: pick }));

  follow(() => {
    const performer = store.openPerformer.value;
    const id = store.openId.value;
    if (!performer || id === null) return;
    engine
      .poses(id, store.performer.value, store.keyposeFrames.value)
      .then((poses) => {
        loaded.value = { performer, poses };
      })
      // The strip goes on without figures; a clip that has gone says so itself.
      .catch(() => undefined);
  });
  follow(() => {
    const result = store.openClip.value?.result;
    const performer = store.openPerformer.value;
    if (!result || !performer) return show(null);
    show({
      frames: result.frames,
      frameTimeS: result.frameTimeS,
      performer,
      keyposes: performer.keyposes,
      poses: loaded.value?.performer === performer ? loaded.value.poses : null,
      currentKeypose: store.currentKeypose.value,
      text: text.value,
    });
  });
}
