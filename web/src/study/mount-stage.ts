/** The stage on the page: the open clip's performers on it, the words over it, the caption spoken when at rest. */
import { computed, effect, signal, type ReadonlySignal } from '@preact/signals-core';
import type { Context } from '../app/context';
import type { Store, ViewPreset } from '../app/store';
import { follow, mount } from '../common/mount';
import { createPoseSource } from '../engine/pose-source';
import type { Stage, StageFailure, StagePerformer } from '../stage';
import { captionOf, type Caption } from './caption';
import { stageOverlay, type StageOverlayProps } from './stage-overlay';

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

type Trouble = StageFailure | 'off' | null;

function createCaption({ store, language }: Context) {
  return computed((): Caption | null => {
    const result = store.openClip.value?.result;
    if (!result) return null;
    return captionOf(language.words.value, {
      frame: store.playback.value.frame,
      frameTimeS: result.frameTimeS,
      keyposes: store.keyposeFrames.value,
      current: store.currentKeypose.value,
      leadingRestFrames: store.openPerformer.value?.leadingRestFrames ?? 0,
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

function sentence({ store, language }: Context, trouble: Trouble): string {
  const { t } = language.words.value;
  const clip = store.openClip.value;
  if (!clip) return store.loading.value ? '' : t('stage.choose');
  if (clip.status === 'failed') return '';
  if (!clip.result) return t('stage.loading', clip.source.name);
  if (trouble === 'off') return t('stage.off');
  if (trouble === 'no-webgl2') return t('stage.unavailable');
  return trouble === 'context-lost' ? t('stage.lost') : '';
}

function failure({ store, language }: Context) {
  const clip = store.openClip.value;
  if (clip?.status !== 'failed' || !clip.failure) return null;
  const { t } = language.words.value;
  const { line, column } = clip.failure;
  const place =
    line === null
      ? ''
      : column === null
        ? t('notes.line', String(line))
        : t('notes.place', String(line), String(column));
  return { name: clip.source.name, place, reason: language.words.value.failure(clip.failure) };
}

/** three.js outweighs all the rest: it comes with the first motions, not with the first screen. */
async function createStage(
  place: HTMLElement,
  { store, theme }: Context,
  settings: StageSettings,
  onTrouble: (trouble: Trouble) => void,
): Promise<Stage> {
  const { Stage } = await import('../stage');
  return new Stage(place, {
    performers: [],
    theme: theme.theme.peek(),
    view: store.view.peek(),
    follow: store.follow.peek(),
    reducedMotion: settings.reducedMotion,
    off: settings.off,
    onViewChange: (view) => {
      store.view.value = view;
    },
    onFailure: onTrouble,
    onRecovery: () => onTrouble(null),
  });
}

/** Calls `act` once, as soon as motions are here or on their way. */
function atFirstMotion({ store }: Context, act: () => void): void {
  let acted = false;
  effect(() => {
    const isDue = store.dropping.value || store.loading.value || store.present.value.length > 0;
    if (acted || !isDue) return;
    acted = true;
    act();
  });
}

export function mountStage(places: StagePlaces, context: Context, settings: StageSettings): void {
  const { store } = context;
  const trouble = signal<Trouble>(settings.off ? 'off' : null);
  const stage = signal<Stage | null>(null);
  const caption = createCaption(context);
  const onTrouble = (next: Trouble): void => {
    trouble.value = next;
  };
  atFirstMotion(context, () => {
    createStage(places.figure, context, settings, onTrouble).then(
      (created) => {
        stage.value = created;
      },
      () => onTrouble('no-webgl2'),
    );
  });
  effect(() => {
    const drawn = trouble.value === null ? stage.value : null;
    store.picture.value = drawn && (() => drawn.snapshot());
  });
  showScene(stage, context);
  showLook(places.stage, stage, context);
  const onView = (view: ViewPreset): void => {
    store.view.value = view;
    stage.peek()?.frameView(view);
  };
  mount(places.overlay, () =>
    stageOverlay(overlayProps(context, caption.value, trouble.value, onView)),
  );
  speak(places.spoken, store, caption);
}

function showLook(
  place: HTMLElement,
  stage: ReadonlySignal<Stage | null>,
  { store, language, theme }: Context,
): void {
  follow(() => {
    const label = language.words.value.t('stage.label');
    const look = { theme: theme.theme.value, view: store.view.value, follow: store.follow.value };
    place.setAttribute('aria-label', label);
    stage.value?.update({ ...look, label });
  });
}

function overlayProps(
  context: Context,
  caption: Caption | null,
  trouble: Trouble,
  onView: (view: ViewPreset) => void,
): StageOverlayProps {
  const { store, language } = context;
  return {
    words: language.words.value,
    caption,
    metric: (store.openPerformer.value?.unit ?? null) !== null,
    drawing: trouble === null,
    sentence: sentence(context, trouble),
    failure: failure(context),
    view: store.view.value,
    follow: store.follow.value,
    onView,
    onFollow: () => {
      store.follow.value = !store.follow.peek();
    },
  };
}

function showScene(stage: ReadonlySignal<Stage | null>, context: Context): void {
  const { store } = context;
  // The same result means the same figures, whatever else has changed about the clip.
  const result = computed(() => store.openClip.value?.result ?? null);
  let performers: StagePerformer[] = [];
  follow(() => {
    performers.forEach(({ source }) => source.destroy());
    performers = stage.value && result.value ? performersOf(context) : [];
    stage.value?.update({ performers });
    stage.value?.show(store.playback.peek().frame);
  });
  follow(() => stage.value?.show(store.playback.value.frame));
}

/** A caption is spoken when the time stands still; while it runs, it would never come to its end. */
function speak(
  place: HTMLElement,
  store: Store,
  caption: { readonly value: Caption | null },
): void {
  follow(() => {
    if (!store.playback.value.playing) place.textContent = caption.value?.spoken ?? '';
  });
}
