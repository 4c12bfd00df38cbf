/**
 * The one state of the page. Actions write it, views read it; what follows from it is computed here
 * once. Clips are never moved in their list, so that a clip's id is its index.
 */
import { computed, signal, type ReadonlySignal, type Signal } from '@preact/signals-core';
import type { ClipId, MethodOptions, MethodSettings, PerformerResult } from '../engine/types';
import type { LoopRange } from '../player/clock';
import { nearestIndex } from '../player/neighbours';
import { keyposeFrames, type Clip } from './clips';
import { createCompareStore, type CompareStore } from './compare-store';
import { labelNames, labelsOf, steadyLabels, type Labels } from './labels';
import { qualifiers } from './names';
import { filterClips, groupClips, sortClips, type Sort } from './order';

export type ViewPreset = 'front' | 'side' | 'top';

export interface PlaybackState {
  readonly frame: number;
  readonly playing: boolean;
  readonly speed: number;
  readonly looping: boolean;
  /** The A–B range in frames, kept while the loop is off; null: the whole clip. */
  readonly loop: LoopRange | null;
}

/** The frames that the timeline shows, from the first to the last; they need not be whole. */
export interface Span {
  readonly first: number;
  readonly last: number;
}

/** Rows of the timeline that can be folded; the others are no higher than a folded one. */
export type FoldableRow = 'speed' | 'scales' | 'intensity';

export type InspectorTab = 'method' | 'body' | 'doctor' | 'export';

/** Files on their way into the library. */
export interface LoadingState {
  /** Keyposes: the files are read and can be compared; their keyposes follow. */
  readonly stage: 'reading' | 'keyposes';
  readonly total: number;
  readonly done: number;
  readonly failed: number;
  /** Folders and archives are still being gone through. */
  readonly searching: boolean;
  /** 0 to 1, by bytes. */
  readonly fraction: number;
  /** null while too little is done to tell. */
  readonly secondsLeft: number | null;
}

export interface Toast {
  readonly kind: 'done' | 'error' | 'info';
  readonly text: string;
  readonly action?: { readonly label: string; readonly run: () => void };
}

export interface Store {
  readonly clips: Signal<readonly Clip[]>;
  readonly openId: Signal<ClipId | null>;
  readonly performer: Signal<number>;
  readonly sort: Signal<Sort>;
  readonly filter: Signal<string>;
  /** Whether the library is grouped by label, where there are labels. */
  readonly groupByLabel: Signal<boolean>;
  /** Labels whose clips are folded away in the library; null: of the clips without one. */
  readonly foldedLabels: Signal<ReadonlySet<string | null>>;
  /** Clips that are ticked, to be labelled or removed together. */
  readonly ticked: Signal<ReadonlySet<ClipId>>;
  readonly playback: Signal<PlaybackState>;
  readonly hoverFrame: Signal<number | null>;
  readonly view: Signal<ViewPreset | null>;
  readonly follow: Signal<boolean>;
  readonly ghosts: Signal<boolean>;
  readonly trails: Signal<boolean>;
  /** Parameters of the method that differ from their default; they hold for all clips. */
  readonly options: Signal<MethodOptions>;
  /** null until the engine has told them. */
  readonly defaults: Signal<MethodSettings | null>;
  /** What the person zoomed to; null: the whole clip. Another clip sets it back. */
  readonly zoom: Signal<Span | null>;
  readonly folded: Signal<ReadonlySet<FoldableRow>>;
  readonly inspectorTab: Signal<InspectorTab>;
  readonly loading: Signal<LoadingState | null>;
  /** Files are on their way; true from the first moment, when `loading` has nothing to tell yet. */
  readonly reading: Signal<boolean>;
  readonly toast: Signal<Toast | null>;
  /** Draws the stage as a PNG; null while nothing is drawn. */
  readonly picture: Signal<(() => Promise<Blob>) | null>;
  readonly helpOpen: Signal<boolean>;
  readonly dropping: Signal<boolean>;
  readonly compare: CompareStore;
  /** The clips that are not removed, in order of arrival. */
  readonly present: ReadonlySignal<readonly Clip[]>;
  /** Whether the library stands in groups. */
  readonly grouped: ReadonlySignal<boolean>;
  /** The clips of the library that the filter lets through, in their order; folded ones among them. */
  readonly shown: ReadonlySignal<readonly Clip[]>;
  readonly qualifiers: ReadonlySignal<ReadonlyMap<ClipId, string>>;
  /** The label of every clip that is present; another map only when a label is another one. */
  readonly labels: ReadonlySignal<Labels>;
  /** Every label once; its place gives it colour and shape (`labelStyle`). */
  readonly labelNames: ReadonlySignal<readonly string[]>;
  readonly openClip: ReadonlySignal<Clip | null>;
  readonly openPerformer: ReadonlySignal<PerformerResult | null>;
  readonly keyposeFrames: ReadonlySignal<Int32Array>;
  /** What the timeline and the strip show of the open clip. */
  readonly span: ReadonlySignal<Span>;
  /** Index of the keypose nearest to the playhead. */
  readonly currentKeypose: ReadonlySignal<number | null>;
}

export const stillPlayback: PlaybackState = {
  frame: 0,
  playing: false,
  speed: 1,
  looping: false,
  loop: null,
};

function writtenState() {
  return {
    clips: signal<readonly Clip[]>([]),
    openId: signal<ClipId | null>(null),
    performer: signal(0),
    sort: signal<Sort>({ key: 'arrival', descending: false }),
    filter: signal(''),
    groupByLabel: signal(true),
    foldedLabels: signal<ReadonlySet<string | null>>(new Set()),
    ticked: signal<ReadonlySet<ClipId>>(new Set()),
    playback: signal(stillPlayback),
    hoverFrame: signal<number | null>(null),
    view: signal<ViewPreset | null>('side'),
    follow: signal(true),
    ghosts: signal(true),
    trails: signal(true),
    options: signal<MethodOptions>({}),
    defaults: signal<MethodSettings | null>(null),
    zoom: signal<Span | null>(null),
    folded: signal<ReadonlySet<FoldableRow>>(new Set()),
    inspectorTab: signal<InspectorTab>('method'),
    loading: signal<LoadingState | null>(null),
    reading: signal(false),
    toast: signal<Toast | null>(null),
    picture: signal<(() => Promise<Blob>) | null>(null),
    helpOpen: signal(false),
    dropping: signal(false),
    compare: createCompareStore(),
  };
}

export function createStore(): Store {
  const state = writtenState();
  const present = computed(() => state.clips.value.filter(({ removed }) => !removed));
  const openClip = computed(() => {
    const clip = state.openId.value === null ? undefined : state.clips.value[state.openId.value];
    return clip && !clip.removed ? clip : null;
  });
  const openPerformer = computed(
    () => openClip.value?.result?.performers[state.performer.value] ?? null,
  );
  const frames = computed(() =>
    openPerformer.value ? keyposeFrames(openPerformer.value) : new Int32Array(),
  );
  const labels = labelling(state.compare, present);
  const names = computed(() => labelNames(labels.value));
  const grouped = computed(() => state.groupByLabel.value && names.value.length > 0);
  const sorted = computed(() =>
    sortClips(filterClips(present.value, state.filter.value, labels.value), state.sort.value),
  );
  return {
    ...state,
    present,
    grouped,
    shown: computed(() =>
      grouped.value ? groupClips(sorted.value, labels.value, names.value) : sorted.value,
    ),
    qualifiers: computed(() => qualifiers(present.value)),
    labels,
    labelNames: names,
    openClip,
    openPerformer,
    keyposeFrames: frames,
    span: computed(() => {
      const last = Math.max(0, (openClip.value?.result?.frames ?? 1) - 1);
      return state.zoom.value ?? { first: 0, last };
    }),
    currentKeypose: computed(() => nearestIndex(frames.value, state.playback.value.frame)),
  };
}

function labelling(
  { labelRule, handLabels, labelRenames }: CompareStore,
  present: ReadonlySignal<readonly Clip[]>,
): ReadonlySignal<Labels> {
  let before: Labels = new Map();
  return computed(() => {
    const [rule, hand, renames] = [labelRule.value, handLabels.value, labelRenames.value];
    return (before = steadyLabels(before, labelsOf(rule, hand, present.value, renames)));
  });
}
