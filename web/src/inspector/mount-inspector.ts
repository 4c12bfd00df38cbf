/** The side panel on the page. */
import { nothing } from 'lit-html';
import type { Context } from '../app/context';
import { mount } from '../common/mount';
import { inspector } from './inspector';

export function mountInspector(
  place: HTMLElement,
  { store, actions, playback, language }: Context,
): void {
  const body = document.createElement('div');
  body.className = 'inspector-body';
  place.append(body);
  mount(body, () => {
    const words = language.words.value;
    place.setAttribute('aria-label', words.t('inspector.label'));
    const clip = store.openClip.value;
    if (!clip) return nothing;
    return inspector({
      words,
      clip,
      performerIndex: store.performer.value,
      onDecide: (key, value) => actions.decide({ id: clip.id, key, value }),
      onPerformer: (index) => actions.choosePerformer(index),
      onFrame: (frame) => playback.seek(frame),
      onExport: (kind) => actions.exportClip(clip.id, kind),
    });
  });
}
