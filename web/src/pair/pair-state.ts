/** The store in; all that the views of the pair page read out: clips, their one time, what stands at it. */
import { computed, effect, signal, type ReadonlySignal, type Signal } from '@preact/signals-core';
import type { Context } from '../app/context';
import type { Warping } from '../engine/comparison-types';
import { nearestIndex } from '../player/neighbours';
import { Ticker } from '../player/ticker';
import { alignedAt, alignedByPaths, alignedByStart, type Alignment } from './alignment';
import { PairClock, type PairMoment } from './pair-clock';
import { followPairClips, type PairClip } from './pair-clips';
import { followWarpings } from './warpings';

/** A frame of a clip of the page. */
export interface ClipMoment {
  readonly clip: number;
  readonly frame: number;
}

export interface PairState {
  readonly clips: ReadonlySignal<readonly PairClip[]>;
  readonly clock: PairClock;
  readonly moment: ReadonlySignal<PairMoment>;
  readonly alignment: ReadonlySignal<Alignment>;
  /** Of B along A. */
  readonly warping: ReadonlySignal<Warping | null>;
  readonly warpProgress: ReadonlySignal<number | null>;
  readonly warpFailure: ReadonlySignal<unknown>;
  /** Of each clip, the index of the keypose nearest to its frame. */
  readonly currentKeyposes: ReadonlySignal<readonly (number | null)[]>;
  /** Of each clip, the keypose at which all meet when synchronised by keypose. */
  readonly meeting: ReadonlySignal<readonly number[]>;
  /** The moment under the pointer. */
  readonly hovered: Signal<ClipMoment | null>;
  /** The keyposes at which the clips are now become those at which they meet. */
  readonly meetHere: () => void;
  /** Goes to a keypose of a clip; synchronised by keypose, the clips meet there from now on. */
  readonly pickKeypose: (clip: number, keypose: number) => void;
}

const noMoment: PairMoment = {
  pairS: 0,
  frames: [],
  playing: false,
  speed: 1,
  looping: false,
  loop: null,
};

export function createPairState(context: Context): PairState {
  const { store, comparer } = context;
  const { page, mirrorB, synchronisation } = store.compare;
  const clips = followPairClips(store);
  const isShown = computed(() => page.value === 'pair');
  const warpings = followWarpings(
    comparer,
    computed(() => (isShown.value ? { clips: clips.value, mirrorB: mirrorB.value } : null)),
  );
  const met = signal<ReadonlyMap<number, number>>(new Map());
  const meeting = computed(() => clips.value.map(({ id }) => met.value.get(id) ?? 0));
  const alignment = computed(() => {
    const shown = clips.value;
    if (synchronisation.value === 'start') return alignedByStart(shown);
    if (synchronisation.value === 'keypose') return alignedAt(shown, meetingTimes(shown, meeting.value));
    return alignedByPaths(
      shown,
      shown.map(({ id }) => warpings.found.value.get(id) ?? null),
    );
  });
  const { clock, moment } = runClock(clips, alignment, isShown);
  const currentKeyposes = computed(() =>
    clips.value.map(({ keyposes }, i) => nearestIndex(keyposes, moment.value.frames[i] ?? 0)),
  );
  const meet = (changes: readonly (readonly [number, number | null])[]): void => {
    const known = changes.flatMap(([clip, keypose]) => {
      const id = clips.peek()[clip]?.id;
      return id === undefined || keypose === null ? [] : [[id, keypose] as const];
    });
    met.value = new Map([...met.peek(), ...known]);
  };
  return {
    clips,
    clock,
    moment,
    alignment,
    warping: computed(() => warpings.found.value.get(clips.value[1]?.id ?? -1) ?? null),
    warpProgress: warpings.progress,
    warpFailure: warpings.failure,
    currentKeyposes,
    meeting,
    hovered: signal<ClipMoment | null>(null),
    meetHere: () => meet(currentKeyposes.peek().map((keypose, clip) => [clip, keypose] as const)),
    pickKeypose: (clip, keypose) => {
      if (synchronisation.peek() === 'keypose') meet([[clip, keypose]]);
      clock.seek(clip, clips.peek()[clip]?.keyposes[keypose] ?? 0);
    },
  };
}

function meetingTimes(clips: readonly PairClip[], meeting: readonly number[]): number[] {
  return clips.map(
    ({ keyposes, frameTimeS }, i) => (keyposes[meeting[i]] ?? keyposes[0] ?? 0) * frameTimeS,
  );
}

function runClock(
  clips: ReadonlySignal<readonly PairClip[]>,
  alignment: ReadonlySignal<Alignment>,
  isShown: ReadonlySignal<boolean>,
) {
  const moment = signal(noMoment);
  const ticker = new Ticker((seconds) => clock.advance(seconds));
  const clock = new PairClock(() => {
    moment.value = clock.moment();
    if (clock.playing) ticker.start();
    else ticker.stop();
  });
  let before: readonly PairClip[] = [];
  effect(() => {
    const now = clips.value;
    // A clip that comes to be A goes on where it was.
    const place = before.findIndex(({ id }) => id === now[0]?.id);
    clock.load(now, alignment.value, place < 0 ? 0 : clock.timeOf(place));
    before = now;
  });
  effect(() => {
    if (!isShown.value) clock.pause();
  });
  return { clock, moment };
}
