/** The keypose strip on the page: there while a clip with a motion is open. */
import { computed, untracked } from '@preact/signals-core';
import type { Context } from '../app/context';
import type { Store } from '../app/store';
import { keep } from '../common/keep';
import { follow } from '../common/mount';
import { KeyposeStrip, type StripProps } from '../strip/keypose-strip';
import { revealed } from '../timeline/zoom';
import { createKeyposePoses, type PoseOwner } from './keypose-poses';
import { stripText } from './study-text';

export function mountStrip(place: HTMLElement, context: Context): void {
  const { engine, store, language } = context;
  const text = computed(() => stripText(language.words.value));
  const poses = createKeyposePoses(engine);
  const show = keep<StripProps>(
    (props) =>
      new KeyposeStrip(place, props, {
        onPick: (keypose) => pick(context, keypose),
        onHover: (frame) => {
          store.hoverFrame.value = frame;
        },
        onShown: (frames) => {
          const owner = untracked(() => ownerOf(store));
          if (owner) poses.want(owner, frames);
        },
      }),
  );
  follow(() => {
    const result = store.openClip.value?.result;
    const performer = store.openPerformer.value;
    const owner = ownerOf(store);
    if (!result || !performer || !owner) return show(null);
    show({
      frames: result.frames,
      frameTimeS: result.frameTimeS,
      span: store.span.value,
      performer,
      keyposes: performer.keyposes,
      poses: poses.of(owner),
      currentKeypose: store.currentKeypose.value,
      text: text.value,
    });
  });
}

function ownerOf({ openId, openPerformer, performer }: Store): PoseOwner | null {
  const id = openId.value;
  const jointCount = openPerformer.value?.skeleton.parents.length;
  if (id === null || jointCount === undefined) return null;
  return { id, performer: performer.value, jointCount };
}

/** Goes to a keypose and scrolls the timeline to it. */
function pick({ store, playback }: Context, keypose: number): void {
  const frame = store.keyposeFrames.peek()[keypose] ?? 0;
  playback.seek(frame);
  if (store.zoom.peek() === null) return;
  store.zoom.value = revealed(store.span.peek(), playback.clock.lastFrame, frame);
}
