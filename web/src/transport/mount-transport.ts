/** The transport on the page. */
import type { Context } from '../app/context';
import { mount } from '../common/mount';
import { transport } from './transport';

export function mountTransport(place: HTMLElement, { store, playback, language }: Context): void {
  mount(place, () => {
    const words = language.words.value;
    place.setAttribute('aria-label', words.t('transport.label'));
    const state = store.playback.value;
    const frames = store.keyposeFrames.value;
    const result = store.openClip.value?.result;
    place.hidden = !result;
    return transport({
      words,
      playback: state,
      timeS: result ? state.frame * result.frameTimeS : 0,
      lastFrame: result ? Math.max(0, result.frames - 1) : 0,
      hasEarlierKeypose: (frames[0] ?? Infinity) < state.frame,
      hasLaterKeypose: (frames.at(-1) ?? -1) > state.frame,
      onPlay: () => playback.toggle(),
      onStep: (direction) => playback.step(direction),
      onKeypose: (direction) => playback.keypose(direction),
      onSpeed: (direction) => playback.speed(direction),
      onLoop: () => playback.loop(),
    });
  });
}
