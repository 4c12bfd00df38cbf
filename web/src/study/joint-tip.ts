/** The place of a figure under the pointer in; its name beside the pointer out. */
import type { ReadonlySignal } from '@preact/signals-core';
import type { Context } from '../app/context';
import { element } from '../common/element';
import { follow } from '../common/mount';
import { performerLetter } from '../figure/performer-letter';
import type { StageHit } from '../stage';
import { jointName } from './joint-names';

const besidePx = 14;

export function showJointTip(
  place: HTMLElement,
  hovered: ReadonlySignal<StageHit | null>,
  context: Context,
): void {
  const tip = element('div', 'tip stage-tip');
  tip.setAttribute('aria-hidden', 'true');
  place.append(tip);
  follow(() => {
    const hit = hovered.value;
    const text = hit && nameOf(context, hit);
    tip.hidden = !text;
    if (!hit || !text) return;
    tip.textContent = text;
    const right = place.clientWidth - tip.offsetWidth - besidePx;
    tip.style.left = `${Math.max(0, Math.min(hit.x + besidePx, right))}px`;
    tip.style.top = `${Math.max(0, hit.y - tip.offsetHeight - besidePx / 2)}px`;
  });
}

/** Another performer's joints are not to be chosen: it itself is. */
function nameOf({ store, language }: Context, { performer, joint }: StageHit): string {
  const words = language.words.value;
  const one = store.openClip.value?.result?.performers[performer];
  if (!one) return '';
  if (performer !== store.performer.value)
    return words.t('recording.performer.number', performerLetter(performer));
  return jointName(words, one, joint);
}
