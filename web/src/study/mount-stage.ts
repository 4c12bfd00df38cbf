/** The stage on the page: the open clip's performers on it, the words over it, the caption spoken when at rest. */
import { computed, effect, signal, type ReadonlySignal } from '@preact/signals-core';
import type { Context } from '../app/context';
import type { Store } from '../app/store';
import { posture } from '../app/posture';
import { follow, followAtOnce, mount } from '../common/mount';
import { createPoseSource } from '../engine/pose-source';
import { performerLetter } from '../figure/performer-letter';
import type { Stage, StageHit, StagePerformer, StageProps } from '../stage';
import { captionOf, type Caption } from './caption';
import { emptyStage } from './empty-stage';
import { jointName, offeredJoints } from './joint-names';
import { showJointTip } from './joint-tip';
import { loadStage, type LoadedStage } from './load-stage';
import { showGhosts, showTrails } from './stage-moments';
import { stageOverlay, type StageOverlayProps } from './stage-overlay';
import { stageSentence, unreadable } from './stage-words';
import { createTrailChoice, type TrailChoice } from './trail-choice';
import { watchCorners } from './watch-corners';

export interface StagePlaces {
  readonly stage: HTMLElement;
  readonly figure: HTMLElement;
  readonly overlay: HTMLElement;
  readonly spoken: HTMLElement;
}

export interface StageSettings {
  /** `?stage=off`: nothing is drawn. */
  readonly off: boolean;
  readonly reducedMotion: boolean;
}

type StageSignal = ReadonlySignal<Stage | null>;

export function mountStage(places: StagePlaces, context: Context, settings: StageSettings): void {
  const { store } = context;
  const caption = createCaption(context);
  const choice = createTrailChoice(store);
  const hovered = signal<StageHit | null>(null);
  const loaded = loadStage(places.figure, store, {
    ...firstProps(context, settings),
    onHover: (hit) => {
      hovered.value = hit;
    },
    onPick: ({ performer, joint }) => {
      if (performer === store.performer.peek()) choice.toggle(joint);
      else context.actions.choosePerformer(performer);
    },
  });
  const { stage, trouble } = loaded;
  effect(() => {
    const drawn = trouble.value === null ? stage.value : null;
    store.picture.value = drawn && (() => drawn.snapshot());
  });
  showScene(stage, context);
  showLook(places.stage, stage, context);
  showGhosts(stage, context);
  showTrails(stage, context, choice);
  showJointTip(places.stage, hovered, context);
  mount(places.overlay, () => stageOverlay(overlayProps(context, caption.value, loaded, choice)));
  watchCorners(places.overlay, (corners) => stage.peek()?.update({ corners }));
  speak(places.spoken, store, caption);
}

function firstProps(context: Context, settings: StageSettings): StageProps {
  const { language, actions } = context;
  return {
    ...emptyStage(context, settings),
    moreContrast: false,
    performerName: (performer) =>
      language.words.peek().t('recording.performer.number', performerLetter(performer)),
    onChoose: (performer) => actions.choosePerformer(performer),
  };
}

function createCaption({ store, language }: Context): ReadonlySignal<Caption | null> {
  return computed((): Caption | null => {
    const result = store.openClip.value?.result;
    if (!result) return null;
    const words = language.words.value;
    const current = store.currentKeypose.value;
    const postures = store.openPerformer.value?.keyposes?.postures ?? [];
    return captionOf(words, {
      frame: store.playback.value.frame,
      frameTimeS: result.frameTimeS,
      keyposes: store.keyposeFrames.value,
      current,
      leadingRestFrames: store.openPerformer.value?.leadingRestFrames ?? 0,
      posture: current === null ? '' : posture(words, postures[current] ?? []),
      performer: result.performers.length > 1 ? performerLetter(store.performer.value) : null,
    });
  });
}

/** Every performer of the open clip with a source of poses of its own. */
function performersOf({ engine, store }: Context): StagePerformer[] {
  const clip = store.openClip.peek();
  const { frames, performers } = clip?.result ?? { frames: 0, performers: [] };
  if (!clip) return [];
  return performers.map((performer, index) => ({
    ...performer,
    source: createPoseSource(engine, clip.id, index, {
      jointCount: performer.skeleton.parents.length,
      frames,
    }),
  }));
}

function showScene(stage: StageSignal, context: Context): void {
  const { store } = context;
  // The same result means the same figures, whatever else has changed about the clip.
  const result = computed(() => store.openClip.value?.result ?? null);
  let performers: StagePerformer[] = [];
  // The poses come while the next frame is waited for, and are drawn in it.
  followAtOnce(() => {
    const before = performers;
    performers = stage.value && result.value ? performersOf(context) : [];
    const { frame } = store.playback.peek();
    performers.forEach(({ source }) => source.prefetch(frame, 0));
    stage.value?.update({ performers });
    stage.value?.show(frame);
    before.forEach(({ source }) => source.destroy());
  });
  follow(() => stage.value?.show(store.playback.value.frame));
  follow(() => stage.value?.update({ chosen: store.performer.value }));
}

function showLook(
  place: HTMLElement,
  stage: StageSignal,
  { store, language, theme }: Context,
): void {
  const contrast = matchMedia('(prefers-contrast: more)');
  const moreContrast = signal(contrast.matches);
  contrast.addEventListener('change', () => {
    moreContrast.value = contrast.matches;
  });
  follow(() => {
    const label = language.words.value.t('stage.label');
    place.setAttribute('aria-label', label);
    stage.value?.update({
      label,
      theme: theme.theme.value,
      view: store.view.value,
      follow: store.follow.value,
      moreContrast: moreContrast.value,
    });
  });
}

function overlayProps(
  context: Context,
  caption: Caption | null,
  { stage, trouble, loadAgain }: LoadedStage,
  choice: TrailChoice,
): StageOverlayProps {
  const { store, language, fullScreen } = context;
  const words = language.words.value;
  const performer = store.openPerformer.value;
  const joints = performer ? offeredJoints(performer, choice.joints.value) : [];
  return {
    words,
    caption,
    metric: (performer?.unit ?? null) !== null,
    drawing: trouble.value === null || trouble.value === 'too-large',
    sentence: stageSentence(context, trouble.value),
    onLoadAgain: trouble.value === 'not-loaded' ? loadAgain : null,
    failure: unreadable(context),
    view: store.view.value,
    shown: { follow: store.follow.value, ghosts: store.ghosts.value, trails: store.trails.value },
    trailJoints: joints.map((joint) => ({
      joint,
      name: performer ? jointName(words, performer, joint) : '',
      drawn: choice.joints.value.includes(joint),
    })),
    trailsAsFound: choice.asFound.value,
    fullScreen: fullScreen.active.value,
    onView: (view) => {
      store.view.value = view;
      stage.peek()?.frameView(view);
    },
    onTurn: () => stage.peek()?.turn(),
    onShow: (what) => {
      store[what].value = !store[what].peek();
    },
    onTrailJoint: choice.toggle,
    onTrailReset: choice.reset,
    onFullScreen: fullScreen.toggle,
  };
}

/** A caption is spoken when the time stands still; while it runs, it would never come to its end. */
function speak(
  place: HTMLElement,
  store: Store,
  caption: { readonly value: Caption | null },
): void {
  follow(() => {
    const shown = store.compare.page.value === 'study';
    if (!shown) place.textContent = '';
    else if (!store.playback.value.playing) place.textContent = caption.value?.spoken ?? '';
  });
}
