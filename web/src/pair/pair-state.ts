/** The store in; all that the views of the pair page read out: clips, their one time, what stands at it. */
import { computed, effect, signal, type ReadonlySignal, type Signal } from '@preact/signals-core';
import type { CompareStore } from '../app/compare-store';
import type { Context } from '../app/context';
import type { Warping } from '../engine/comparison-types';
import type { ClipId } from '../engine/types';
import { nearestIndex } from '../player/neighbours';
import { Ticker } from '../player/ticker';
import { alignedAt, alignedByPaths, alignedByStart, type Alignment } from './alignment';
import { startOfA } from './opening';
import { PairClock, type PairMoment } from './pair-clock';
import { followPairClips, type PairClip } from './pair-clips';
import { createRowsView, type RowsView } from './rows-view';
import { followWarpings, type Warpings } from './warpings';

export type LoopOfPair = Pick<PairMoment, 'loop' | 'looping'>;

/** A frame of a clip of the page. */
export interface ClipMoment {
  readonly clip: number;
  readonly frame: number;
}

export interface PairState {
  readonly clips: ReadonlySignal<readonly PairClip[]>;
  readonly clock: PairClock;
  readonly moment: ReadonlySignal<PairMoment>;
  /** A–B, and whether it is on; changes only when they do. */
  readonly loop: ReadonlySignal<LoopOfPair>;
  readonly alignment: ReadonlySignal<Alignment>;
  /** Of B along A. */
  readonly warping: ReadonlySignal<Warping | null>;
  readonly warpings: Pick<
    Warpings,
    'underWay' | 'progress' | 'failure' | 'cancelled' | 'cancel' | 'warp'
  >;
  /** Of each clip, the index of the keypose nearest to its frame. */
  readonly currentKeyposes: ReadonlySignal<readonly (number | null)[]>;
  /** Of each clip, the keypose at which all meet when synchronised by keypose. */
  readonly meeting: ReadonlySignal<readonly number[]>;
  /** What the rows show. */
  readonly rows: RowsView;
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
  const { mirrorB, synchronisation } = store.compare;
  const clips = followPairClips(store);
  const warpings = followWarpings(
    comparer,
    computed(() => ({ clips: clips.value, mirrorB: mirrorB.value })),
  );
  const met = createMeeting(clips);
  const alignment = followAlignment(store.compare, clips, met.keyposes, warpings.found);
  const { clock, moment } = runClock(context, clips, alignment);
  const currentKeyposes = computed(() =>
    clips.value.map(({ keyposes }, i) => nearestIndex(keyposes, moment.value.frames[i] ?? 0)),
  );
  return {
    clips,
    clock,
    moment,
    loop: loopOf(moment),
    alignment,
    warping: computed(() => warpings.found.value.get(clips.value[1]?.id ?? -1) ?? null),
    warpings,
    currentKeyposes,
    meeting: met.keyposes,
    rows: createRowsView({ clips, moment, alignment }),
    hovered: signal<ClipMoment | null>(null),
    meetHere: () => met.set(currentKeyposes.peek()),
    pickKeypose: (clip, keypose) => {
      if (synchronisation.peek() === 'keypose')
        met.set(clips.peek().map((_, place) => (place === clip ? keypose : null)));
      clock.seek(clip, clips.peek()[clip]?.keyposes[keypose] ?? 0);
    },
  };
}

function loopOf(moment: ReadonlySignal<PairMoment>): ReadonlySignal<LoopOfPair> {
  let before: LoopOfPair = noMoment;
  return computed(() => {
    const { loop, looping } = moment.value;
    const isSame = loop?.fromS === before.loop?.fromS && loop?.toS === before.loop?.toS;
    if (!isSame || looping !== before.looping) before = { loop, looping };
    return before;
  });
}

function followAlignment(
  { synchronisation }: Pick<CompareStore, 'synchronisation'>,
  clips: ReadonlySignal<readonly PairClip[]>,
  meeting: ReadonlySignal<readonly number[]>,
  warpings: ReadonlySignal<ReadonlyMap<ClipId, Warping>>,
): ReadonlySignal<Alignment> {
  return computed(() => {
    const shown = clips.value;
    if (synchronisation.value === 'start') return alignedByStart(shown);
    if (synchronisation.value === 'keypose')
      return alignedAt(shown, meetingTimes(shown, meeting.value));
    return alignedByPaths(
      shown,
      shown.map(({ id }) => warpings.value.get(id) ?? null),
    );
  });
}

/** The keyposes at which the clips meet, kept by clip; at first the first ones. */
function createMeeting(clips: ReadonlySignal<readonly PairClip[]>) {
  const met = signal<ReadonlyMap<ClipId, number>>(new Map());
  return {
    keyposes: computed(() => clips.value.map(({ id }) => met.value.get(id) ?? 0)),
    /** Of each clip; null leaves it as it is. */
    set: (keyposes: readonly (number | null)[]): void => {
      const all = new Map(met.peek());
      clips.peek().forEach(({ id }, place) => {
        const keypose = keyposes[place] ?? null;
        if (keypose !== null) all.set(id, keypose);
      });
      met.value = all;
    },
  };
}

function meetingTimes(clips: readonly PairClip[], meeting: readonly number[]): number[] {
  return clips.map(
    ({ keyposes, frameTimeS }, i) => (keyposes[meeting[i]] ?? keyposes[0] ?? 0) * frameTimeS,
  );
}

/** Study and pair hand the moment of A to each other. */
function runClock(
  { store, playback }: Context,
  clips: ReadonlySignal<readonly PairClip[]>,
  alignment: ReadonlySignal<Alignment>,
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
    const [a] = before;
    if (now.length === 0) {
      clock.pause();
      if (a && a.id === store.openId.peek()) playback.seek(clock.frameOf(0));
    } else playback.pause();
    const was = {
      clips: before,
      frameOf: (place: number) => clock.frameOf(place),
      timeOf: (place: number) => clock.timeOf(place),
    };
    const start = now[0] && startOfA(now[0], was, store.playback.peek().frame);
    clock.load(now, alignment.value, start, a !== undefined && a.id === now[0]?.id);
    before = now;
  });
  return { clock, moment };
}
