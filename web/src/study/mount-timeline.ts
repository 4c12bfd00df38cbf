/** Timeline of the open clip on the page: there while a clip with a motion is open. */
import { computed } from '@preact/signals-core';
import type { Context } from '../app/context';
import { keep } from '../common/keep';
import { follow } from '../common/mount';
import { Timeline, type TimelineProps } from '../timeline/timeline';
import { timelineText } from './study-text';

export function mountTimeline(
  place: HTMLElement,
  { store, playback, language, theme }: Context,
): void {
  const text = computed(() => timelineText(language.words.value));
  const seek = (frame: number): void => playback.seek(frame);
  const hover = (frame: number | null): void => {
    store.hoverFrame.value = frame;
  };
  const show = keep<TimelineProps>(
    (props) => new Timeline(place, props, { onSeek: seek, onHover: hover }),
  );
  follow(() => {
    const result = store.openClip.value?.result;
    const performer = store.openPerformer.value;
    if (!result || !performer) return show(null);
    show({
      frames: result.frames,
      frameTimeS: result.frameTimeS,
      leadingRestFrames: performer.leadingRestFrames,
      keyposes: performer.keyposes,
      currentKeypose: store.currentKeypose.value,
      frame: store.playback.value.frame,
      hoverFrame: store.hoverFrame.value,
      theme: theme.theme.value,
      text: text.value,
    });
  });
}
