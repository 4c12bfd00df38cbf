/** The state of the pair page and A or B in; the strip of its keyposes and its row of pins out. */
import { computed } from '@preact/signals-core';
import type { Context } from '../app/context';
import { follow } from '../common/mount';
import { createKeyposePoses, type PoseOwner } from '../study/keypose-poses';
import { keyposeText, timelineText } from '../study/study-text';
import { layoutPins } from '../timeline/pin-layout';
import { PinRow } from '../timeline/pin-row';
import type { PairClip } from './pair-clips';
import type { PairState } from './pair-state';
import { PairStrip } from './pair-strip';
import { placeAt } from './place-at';
import { rows } from './rows-layout';
import { pairYaw } from './stands';
import type { TwoSignal } from './two';

export function showStrip(
  area: HTMLElement,
  clip: 0 | 1,
  context: Context,
  state: PairState,
  two: TwoSignal,
): void {
  const { engine, language, store } = context;
  const place = placeAt(area, 'pair-strip-place', [rows.stripA, rows.stripB][clip]);
  const poses = createKeyposePoses(engine);
  const strip = new PairStrip(place, {
    onPick: (keypose) => state.pickKeypose(clip, keypose),
    onHover: (frame) => {
      state.hovered.value = frame === null ? null : { clip, frame };
    },
    onShown: (frames) => {
      const shown = state.clips.peek()[clip];
      if (shown) poses.want(ownerOf(shown), frames);
    },
  });
  follow(() => {
    const shown = two.value;
    if (!shown) return;
    const one = [shown.a, shown.b][clip];
    const words = language.words.value;
    strip.update({
      axis: shown.axes[clip],
      frameTimeS: one.frameTimeS,
      performer: one.performer,
      yawRad: pairYaw(shown.a, one),
      mirrored: clip === 1 && store.compare.mirrorB.value,
      keyposes: one.keyposes,
      poses: poses.of(ownerOf(one)),
      current: state.currentKeyposes.value[clip] ?? null,
      label: words.t('pair.strip', one.letter),
      keyposeName: keyposeText(words),
    });
  });
}

function ownerOf({ id, performerIndex, performer }: PairClip): PoseOwner {
  return { id, performer: performerIndex, jointCount: performer.skeleton.parents.length };
}

export function showPins(
  area: HTMLElement,
  clip: 0 | 1,
  { language }: Context,
  state: PairState,
  two: TwoSignal,
): void {
  const place = placeAt(area, 'pair-pins', [rows.pinsA, rows.pinsB][clip]);
  const pick = (keypose: number): void => state.pickKeypose(clip, keypose);
  const open = (first: number, last: number): void => {
    const { keyposes } = state.clips.peek()[clip];
    state.rows.open(clip, keyposes[first], keyposes[last]);
  };
  const pins = new PinRow({ onPick: pick, onOpen: open });
  place.append(pins.element);
  const text = computed(() => {
    const words = language.words.value;
    return { ...timelineText(words), pins: words.t('pair.pins', 'AB'[clip]) };
  });
  follow(() => {
    const shown = two.value;
    if (!shown) return;
    const { keyposes, frameTimeS } = [shown.a, shown.b][clip];
    const axis = shown.axes[clip];
    pins.update(layoutPins(keyposes, axis), axis, keyposes, frameTimeS, text.value);
  });
  follow(() => {
    void two.value;
    pins.markCurrent(state.currentKeyposes.value[clip] ?? null);
  });
}
