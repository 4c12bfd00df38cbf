/** The state of the pair page in; its two stages or the one out, with what stands over them. */
import { computed, effect, signal, type ReadonlySignal } from '@preact/signals-core';
import type { Context } from '../app/context';
import { element } from '../common/element';
import { follow, mount } from '../common/mount';
import { performerLetter } from '../figure/performer-letter';
import type { Placement } from '../figure/placement';
import type { Look, Stage, StageProps } from '../stage';
import { emptyStage } from '../study/empty-stage';
import { loadStage, type LoadedStage } from '../study/load-stage';
import type { StageSettings } from '../study/mount-stage';
import { watchCorners } from '../study/watch-corners';
import type { PairState } from './pair-state';
import { PoseSources } from './pose-sources';
import { sceneOf, type StageScene } from './scene-of';
import { showKeyposes, showTrails, type ShownClip } from './stage-moments';
import { stageOverlay } from './stage-overlay';
import { stageWords } from './stage-words';
import { followMeeting, type Meeting } from './together';

/** Both stages have one scale, with room for the keyposes around. */
export const ROOM = 1.2;

type StageSignal = ReadonlySignal<Stage | null>;

/** What the stages show, for who draws it elsewhere. */
export interface PairStages {
  readonly stages: readonly ShownStage[];
  /** Where superposed clips stand; null while that is not known. */
  readonly placements: ReadonlySignal<readonly Placement[] | null>;
}

interface ShownStage {
  readonly stage: StageSignal;
  /** Whose keyposes and trails are shown. */
  readonly shown: ReadonlySignal<ShownClip | null>;
}

export function mountStages(
  place: HTMLElement,
  context: Context,
  state: PairState,
  settings: StageSettings,
): PairStages {
  const { superposed, mirrorB } = context.store.compare;
  const sources = new PoseSources(context.engine);
  const placements = followMeeting(
    context.engine,
    computed(() => meetingOf(context, state)),
  );
  effect(() => sources.keep(state.clips.value));
  follow(() => place.classList.toggle('superposed', superposed.value));
  const stages: ShownStage[] = [];
  for (const index of [0, 1] as const) {
    const scene = computed(() =>
      sceneOf(
        index,
        {
          clips: state.clips.value,
          superposed: superposed.value,
          mirrorB: mirrorB.value,
          placements: placements.value,
        },
        sources,
      ),
    );
    // Who turns one figure sees the other from there too.
    const onLook = (look: Look): void => stages[1 - index]?.stage.peek()?.lookFrom(look);
    stages.push(mountOne(place, index, { context, state, settings, scene, onLook }));
  }
  return { stages, placements };
}

/** Where superposed clips stand in one place: at the start, at the keypose, at the path's beginning. */
function meetingOf({ store }: Context, state: PairState): Meeting | null {
  const { superposed, mirrorB, synchronisation } = store.compare;
  const clips = state.clips.value;
  if (!superposed.value) return null;
  const byKeypose = synchronisation.value === 'keypose';
  const frames = clips.map(({ keyposes, performer, frames: count }, i) => {
    const keypose = keyposes[state.meeting.value[i]] ?? keyposes[0];
    const first = Math.min(performer.leadingRestFrames, count - 1);
    return byKeypose && keypose !== undefined ? keypose : first;
  });
  return { clips, frames, mirrorB: mirrorB.value };
}

interface Parts {
  readonly context: Context;
  readonly state: PairState;
  readonly settings: StageSettings;
  readonly scene: ReadonlySignal<StageScene>;
  readonly onLook: (look: Look) => void;
}

function mountOne(place: HTMLElement, index: 0 | 1, parts: Parts): ShownStage {
  const { context, state, settings, scene, onLook } = parts;
  const section = element('section', 'stage pair-stage');
  const figure = element('div', 'stage-figure');
  const overlay = element('div', 'stage-overlay');
  section.append(figure, overlay);
  place.append(section);
  const chosen = signal(0);
  const loaded = loadStage(figure, context.store, {
    ...firstProps(context, settings),
    onLook,
    onChoose: (performer) => {
      chosen.value = performer;
    },
  });
  const { stage } = loaded;
  const shown = computed((): ShownClip | null => {
    const { places } = scene.value;
    const clip = places[Math.min(chosen.value, places.length - 1)];
    const pairClip = state.clips.value[clip];
    return pairClip ? { place: clip, clip: pairClip } : null;
  });
  follow(() => {
    section.hidden = index === 1 && context.store.compare.superposed.value;
  });
  showScene(stage, parts, shown);
  showLook(section, stage, index, context);
  showKeyposes(stage, shown, context, state);
  showTrails(stage, shown, context, state);
  showWords(overlay, index, parts, loaded, shown);
  keepCorners(overlay, stage);
  return { stage, shown };
}

function showWords(
  overlay: HTMLElement,
  index: 0 | 1,
  { context, state }: Parts,
  { stage, trouble, loadAgain }: LoadedStage,
  shown: ReadonlySignal<ShownClip | null>,
): void {
  mount(overlay, () =>
    stageOverlay({
      ...stageWords(index, context, state, trouble.value, shown.value?.place ?? null),
      onLoadAgain: trouble.value === 'not-loaded' ? loadAgain : null,
      onView: (view) => {
        context.store.view.value = view;
        stage.peek()?.frameView(view);
      },
    }),
  );
}

/** Tags stay away from the caption. */
function keepCorners(overlay: HTMLElement, stage: StageSignal): void {
  const corners = signal<StageProps['corners']>({ left: 0, right: 0 });
  watchCorners(overlay, (widths) => {
    corners.value = widths;
  });
  follow(() => stage.value?.update({ corners: corners.value }));
}

function firstProps(context: Context, settings: StageSettings): StageProps {
  const { language } = context;
  return {
    ...emptyStage(context, settings),
    room: ROOM,
    moreContrast: matchMedia('(prefers-contrast: more)').matches,
    performerName: (place) => language.words.peek().t('pair.choose', performerLetter(place)),
  };
}

function showScene(
  stage: StageSignal,
  { state, scene }: Parts,
  shown: ReadonlySignal<ShownClip | null>,
): void {
  const frames = (): number[] =>
    scene.value.places.map((place) => state.moment.value.frames[place] ?? 0);
  follow(() => {
    const { performers, places } = scene.value;
    const chosen = Math.max(0, places.indexOf(shown.value?.place ?? 0));
    stage.value?.update({ performers, chosen });
  });
  follow(() => stage.value?.show(frames()));
}

function showLook(
  section: HTMLElement,
  stage: StageSignal,
  index: 0 | 1,
  { store, theme, language }: Context,
): void {
  follow(() => {
    const { t } = language.words.value;
    const count = 2 + store.compare.alsoIds.value.length;
    const label = store.compare.superposed.value
      ? t('pair.stage.all', count)
      : t('pair.stage', 'AB'[index]);
    section.setAttribute('aria-label', label);
    stage.value?.update({
      label,
      theme: theme.theme.value,
      view: store.view.value,
      follow: store.follow.value,
    });
  });
}
