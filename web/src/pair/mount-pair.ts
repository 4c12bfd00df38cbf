/** The place of the page in; two or more clips on one clock out. */
import '../styles/pair.css';
import { html, type TemplateResult } from 'lit-html';
import type { Context } from '../app/context';
import { element } from '../common/element';
import { follow, mount } from '../common/mount';
import type { StageSettings } from '../study/mount-stage';
import { mountClipChoice } from './clip-choice';
import { explanationOf } from './distance-text';
import { distanceSections } from './distance-sections';
import { loopTimes } from './loop-frames';
import { mountFilm } from './mount-film';
import { mountRows } from './mount-rows';
import { mountStages } from './mount-stages';
import { pairBar } from './pair-bar';
import { pairKeys } from './pair-keys';
import { pairSide } from './pair-side';
import { createPairState, type PairState } from './pair-state';
import { pairTransport } from './pair-transport';
import { captionAt } from './stage-words';
import { timingOf } from './timing';

export function mountPair(place: HTMLElement, context: Context, settings: StageSettings): void {
  const state = createPairState(context);
  const places = layOut(place);
  context.pageKeys.set('pair', pairKeys(state));
  chooseOther(context);
  mountBar(places.bar, context, state);
  const stages = mountStages(places.stages, context, state, settings);
  mountTransport(places.transport, context, state);
  mountRows(places.rows, context, state);
  mountSide(places, context, state);
  mountFilm(places.foot, context, state, stages);
  const middle = document.querySelector<HTMLElement>('#top-middle');
  if (middle) mountClipChoice(middle, context);
  speak(places.spoken, context, state);
  follow(() => place.setAttribute('aria-label', context.language.words.value.t('pair.page')));
}

function layOut(place: HTMLElement) {
  const page = element('div', 'pair-page');
  const main = element('div', 'pair-main');
  const places = {
    bar: element('div', 'pair-bar'),
    stages: element('div', 'pair-stages'),
    transport: element('div', 'transport pair-transport'),
    rows: element('div', 'pair-rows'),
    aside: element('aside', 'pair-side'),
    side: element('div', 'pair-side-body'),
    foot: element('div', 'pair-side-foot'),
    spoken: element('div', 'spoken'),
  };
  const time = element('div', 'time');
  places.bar.setAttribute('role', 'toolbar');
  places.transport.setAttribute('role', 'toolbar');
  places.spoken.setAttribute('aria-live', 'polite');
  time.append(places.transport, places.rows);
  main.append(places.bar, places.stages, time);
  places.aside.append(places.side, places.foot);
  page.append(main, places.aside, places.spoken);
  place.append(page);
  return places;
}

/** Who comes here with one clip sees it beside the one most like it. */
function chooseOther({ store, compareActions }: Context): void {
  follow(() => {
    const { page, otherId, neighbours } = store.compare;
    const openId = store.openId.value;
    const other = otherId.value;
    const isGone = other === null || store.clips.value[other]?.removed === true;
    if (page.value !== 'pair' || openId === null || !isGone) return;
    const near = neighbours.value.find(({ clip }) => clip !== openId)?.clip;
    const next = store.shown.value.find(({ id, status }) => id !== openId && status !== 'failed');
    const found = near ?? next?.id;
    if (found !== undefined) compareActions.selectOther(found);
  });
}

function mountBar(place: HTMLElement, { store, language }: Context, state: PairState): void {
  const { superposed, synchronisation, mirrorB } = store.compare;
  mount(place, () => {
    const words = language.words.value;
    place.setAttribute('aria-label', words.t('pair.page'));
    return pairBar({
      words,
      superposed: superposed.value,
      synchronisation: synchronisation.value,
      mirrorB: mirrorB.value,
      keyposes: store.ghosts.value,
      follow: store.follow.value,
      onSuperpose: (together) => {
        superposed.value = together;
      },
      onSynchronise: (way) => {
        if (way === 'keypose') state.meetHere();
        synchronisation.value = way;
      },
      onMirror: () => {
        mirrorB.value = !mirrorB.peek();
      },
      onKeyposes: () => {
        store.ghosts.value = !store.ghosts.peek();
      },
      onFollow: () => {
        store.follow.value = !store.follow.peek();
      },
    });
  });
}

function mountTransport(place: HTMLElement, { language }: Context, state: PairState): void {
  const { clock } = state;
  mount(place, () => {
    const words = language.words.value;
    const moment = state.moment.value;
    const clips = state.clips.value;
    place.setAttribute('aria-label', words.t('pair.transport'));
    place.hidden = clips.length < 2;
    const [a] = clips;
    const timeOf = (i: number): number => (moment.frames[i] ?? 0) * (clips[i]?.frameTimeS ?? 0);
    return pairTransport({
      words,
      moment,
      timesS: [timeOf(0), timeOf(1)],
      rangeS: moment.loop && loopTimes(moment.loop, state.alignment.value),
      atStart: moment.pairS <= 0,
      atEnd: moment.pairS >= state.alignment.value.durationS,
      hasEarlierKeypose: (a?.keyposes[0] ?? Infinity) < (moment.frames[0] ?? 0),
      hasLaterKeypose: (a?.keyposes.at(-1) ?? -1) > (moment.frames[0] ?? 0),
      zooms: state.rows.zooms.value,
      onPlay: () => clock.toggle(),
      onStep: (direction) => clock.step(direction),
      onKeypose: (direction) => clock.keypose(0, a?.keyposes ?? new Int32Array(), direction),
      onSpeed: (speed) => clock.setSpeed(speed),
      onLoop: () => clock.toggleLoop(),
      onLoopClear: () => clock.setLoop(null),
      onZoom: (way) => state.rows.zoom(way),
    });
  });
}

function mountSide(
  { aside, side }: { readonly aside: HTMLElement; readonly side: HTMLElement },
  context: Context,
  state: PairState,
): void {
  mount(side, (): TemplateResult => {
    const words = context.language.words.value;
    const [a, b] = state.clips.value;
    aside.setAttribute('aria-label', words.t('pair.details'));
    if (!a || !b) return html``;
    const [timingA, timingB] = [a, b].map(({ keyposes, performer, frameTimeS }) =>
      timingOf(keyposes, performer.keyposes, frameTimeS),
    );
    return pairSide({
      words,
      timings: [timingA, timingB],
      distance: distanceSections(context, explanationOf(context)),
    });
  });
}

/** What the clips show is spoken when the time stands still. */
function speak(place: HTMLElement, context: Context, state: PairState): void {
  follow(() => {
    const { t } = context.language.words.value;
    const { playing } = state.moment.value;
    if (playing) return;
    const captions = state.clips.value.slice(0, 2).map(({ letter }, i) => {
      const spoken = captionAt(context, state, i)?.spoken ?? '';
      return t('pair.spoken.caption', letter, spoken);
    });
    place.textContent = captions.join('. ');
  });
}
