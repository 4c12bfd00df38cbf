/** The transport on the page. */
import type { Context } from '../app/context';
import type { Store } from '../app/store';
import { mount } from '../common/mount';
import { SHORTEST_SPAN } from '../timeline/zoom';
import { transport } from './transport';
import { zoom, type Zoom } from './zooming';

function zooms({ span, zoom: zoomed, openClip }: Store): Record<Zoom, boolean> {
  const { first, last } = span.value;
  const isZoomed = zoomed.value !== null;
  const frames = openClip.value?.result?.frames ?? 0;
  const least = Math.min(SHORTEST_SPAN, frames - 1);
  return { in: last - first > least + 1e-6, out: isZoomed, all: isZoomed };
}

export function mountTransport(place: HTMLElement, context: Context): void {
  const { store, playback, actions, language } = context;
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
      frameTimeS: result?.frameTimeS ?? 1,
      lastFrame: result ? Math.max(0, result.frames - 1) : 0,
      hasEarlierKeypose: (frames[0] ?? Infinity) < state.frame,
      hasLaterKeypose: (frames.at(-1) ?? -1) > state.frame,
      zooms: zooms(store),
      picture: store.picture.value !== null,
      onPlay: () => playback.toggle(),
      onStep: (direction) => playback.step(direction),
      onKeypose: (direction) => playback.keypose(direction),
      onSpeed: (speed) => playback.clock.setSpeed(speed),
      onLoop: () => playback.loop(),
      onLoopClear: () => playback.setLoop(null),
      onZoom: (way) => zoom(store, way),
      onPicture: () => actions.savePicture(),
    });
  });
}
