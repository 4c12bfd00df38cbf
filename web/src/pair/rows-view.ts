/** The clips and their one time in; which seconds of A and B the rows show, and what changes that, out. */
import { computed, effect, signal, type ReadonlySignal } from '@preact/signals-core';
import { SHORTEST_SPAN, ZOOM_STEP } from '../timeline/zoom';
import type { Zoom } from '../transport/zooming';
import type { Alignment } from './alignment';
import type { PairMoment } from './pair-clock';
import type { PairClip } from './pair-clips';
import {
  followedRows,
  groundOf,
  openedRows,
  pannedRows,
  zoomedRows,
  type RowsSpan,
  type Times,
} from './rows-span';

export interface RowsView {
  /** null: all. */
  readonly span: ReadonlySignal<RowsSpan | null>;
  /** The ways in which the zoom can still go. */
  readonly zooms: ReadonlySignal<Readonly<Record<Zoom, boolean>>>;
  /** The moments shown keep their places. */
  readonly zoom: (way: Zoom) => void;
  /** A frame of a clip, and what is beside it, keep their places. */
  readonly zoomAbout: (clip: 0 | 1, frame: number, factor: number) => void;
  readonly pan: (clip: 0 | 1, seconds: number) => void;
  /** Shows the frames from … to of a clip. */
  readonly open: (clip: 0 | 1, from: number, to: number) => void;
}

interface Shown {
  readonly clips: ReadonlySignal<readonly PairClip[]>;
  readonly moment: ReadonlySignal<PairMoment>;
  readonly alignment: ReadonlySignal<Alignment>;
}

export function createRowsView(shown: Shown): RowsView {
  const { clips, moment, alignment } = shown;
  const span = signal<RowsSpan | null>(null);
  const set = (change: (all: readonly PairClip[]) => RowsSpan | null): void => {
    if (clips.peek().length > 1) span.value = change(clips.peek());
  };
  /** A moment of a clip, and the one beside it. */
  const beside = (clip: 0 | 1, frame: number): Times => {
    const at = alignment.peek();
    const timeS = frame * clips.peek()[clip].frameTimeS;
    const other = at.timeOf(1 - clip, at.pairTimeOf(clip, timeS));
    return clip === 0 ? [timeS, other] : [other, timeS];
  };
  follow(shown, span);
  return {
    span,
    zooms: computed(() => {
      const { unitS, units } = groundOf(clips.value);
      const lengthS = span.value?.lengthS ?? units * unitS;
      const isZoomed = span.value !== null;
      const least = Math.min(SHORTEST_SPAN, units) * unitS;
      return { in: lengthS > least * (1 + 1e-6), out: isZoomed, all: isZoomed };
    }),
    zoom: (way) =>
      set((all) => {
        const factor = way === 'in' ? ZOOM_STEP : 1 / ZOOM_STEP;
        const now = timesOf(all, moment.peek());
        return way === 'all' ? null : zoomedRows(span.peek(), groundOf(all), factor, now);
      }),
    zoomAbout: (clip, frame, factor) =>
      set((all) => zoomedRows(span.peek(), groundOf(all), factor, beside(clip, frame))),
    pan: (clip, seconds) =>
      set((all) => pannedRows(span.peek(), groundOf(all), clip, seconds, alignment.peek())),
    open: (clip, from, to) =>
      set((all) => openedRows(groundOf(all), beside(clip, from), beside(clip, to))),
  };
}

const timesOf = ([a, b]: readonly PairClip[], { frames }: PairMoment): Times => [
  (frames[0] ?? 0) * (a?.frameTimeS ?? 0),
  (frames[1] ?? 0) * (b?.frameTimeS ?? 0),
];

/** Other clips are shown whole; the time takes the view along. */
function follow(
  { clips, moment }: Shown,
  span: { value: RowsSpan | null; peek(): RowsSpan | null },
) {
  let ids = '';
  let beforeS: Times = [0, 0];
  effect(() => {
    const all = clips.value;
    const timeS = timesOf(all, moment.value);
    const { playing } = moment.value;
    const now = all
      .slice(0, 2)
      .map(({ id }) => id)
      .join();
    const hasMoved = timeS[0] !== beforeS[0] || timeS[1] !== beforeS[1];
    if (now !== ids) span.value = null;
    else if (hasMoved && all.length > 1)
      span.value = followedRows(span.peek(), groundOf(all), { beforeS, timeS, playing });
    [ids, beforeS] = [now, timeS];
  });
}
