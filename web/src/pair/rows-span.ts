/**
 * Which seconds of A and of B the rows show, after zooming, panning or following the time: pure. Both show
 * as many seconds, each its own; null stands for all.
 */
import { followed } from '../study/follow-playhead';
import type { AxisSpan } from '../timeline/axis';
import { fitted, pageFrom, panned, revealed, zoomed } from '../timeline/zoom';
import type { Alignment, ClipLength } from './alignment';

/** Air around what is opened, in parts of its length. */
const OPEN_AIR = 0.15;

export interface RowsSpan {
  readonly lengthS: number;
  /** The first second of A, of B. */
  readonly firstS: readonly [number, number];
}

/** Of A and of B. */
export type Times = readonly [number, number];

/** The axis of both: as long as the longer clip, in frames of the one with the shorter frames. */
export interface RowsGround {
  readonly unitS: number;
  readonly units: number;
}

export function groundOf(all: readonly ClipLength[]): RowsGround {
  const clips = all.slice(0, 2);
  const unitS = Math.min(...clips.map(({ frameTimeS }) => frameTimeS));
  const longestS = Math.max(...clips.map(({ frames, frameTimeS }) => (frames - 1) * frameTimeS));
  return { unitS, units: Math.max(1, longestS / unitS) };
}

/** All of it. */
export function wholeRows({ unitS, units }: RowsGround): RowsSpan {
  return { lengthS: units * unitS, firstS: [0, 0] };
}

/** Zooms in by a factor above 1; a moment of A and one of B keep their places. */
export function zoomedRows(
  span: RowsSpan | null,
  ground: RowsGround,
  factor: number,
  aboutS: Times,
): RowsSpan | null {
  return ofBoth(span, ground, (one, clip) =>
    zoomed(one, ground.units, factor, aboutS[clip] / ground.unitS),
  );
}

/** Moves a clip on by seconds; the other goes with it, as the two run together. */
export function pannedRows(
  span: RowsSpan | null,
  ground: RowsGround,
  clip: 0 | 1,
  seconds: number,
  alignment: Alignment,
): RowsSpan | null {
  if (!span) return null;
  const other = clip === 0 ? 1 : 0;
  const middleS = span.firstS[clip] + span.lengthS / 2;
  const beside = (timeS: number): number =>
    alignment.timeOf(other, alignment.pairTimeOf(clip, timeS));
  const otherS = beside(middleS + seconds) - beside(middleS);
  return ofBoth(span, ground, (one, at) =>
    panned(one, ground.units, (at === clip ? seconds : otherS) / ground.unitS),
  );
}

/** The moments between times of both, with air around. */
export function openedRows(ground: RowsGround, fromS: Times, toS: Times): RowsSpan | null {
  const lengthS = Math.max(toS[0] - fromS[0], toS[1] - fromS[1]) * (1 + 2 * OPEN_AIR);
  const first = (clip: 0 | 1): number => (fromS[clip] + toS[clip] - lengthS) / 2;
  return ofBoth({ lengthS, firstS: [first(0), first(1)] }, ground, (one) =>
    fitted(one, ground.units),
  );
}

export interface RowsMove {
  readonly beforeS: Times;
  readonly timeS: Times;
  readonly playing: boolean;
}

/** The view goes with the time: page by page while it plays, both at once; else just so far. */
export function followedRows(
  span: RowsSpan | null,
  ground: RowsGround,
  { beforeS, timeS, playing }: RowsMove,
): RowsSpan | null {
  if (!span) return null;
  const { unitS, units } = ground;
  const place = (clip: 0 | 1): number => timeS[clip] / unitS;
  if (!playing) return ofBoth(span, ground, (one, clip) => revealed(one, units, place(clip)));
  const turns = ([0, 1] as const).some((clip) => {
    const one = spanOf(span, ground, clip);
    const before = beforeS[clip] / unitS;
    const move = { before, frame: place(clip), playing, frameTimeS: unitS };
    return followed(one, units, move)?.first !== one.first;
  });
  return turns ? ofBoth(span, ground, (one, clip) => pageFrom(one, units, place(clip))) : span;
}

function spanOf({ lengthS, firstS }: RowsSpan, { unitS }: RowsGround, clip: 0 | 1): AxisSpan {
  const first = firstS[clip] / unitS;
  return { first, last: first + lengthS / unitS };
}

/** Null where that is all. */
function ofBoth(
  span: RowsSpan | null,
  ground: RowsGround,
  change: (span: AxisSpan, clip: 0 | 1) => AxisSpan | null,
): RowsSpan | null {
  const { unitS } = ground;
  const shown = span ?? wholeRows(ground);
  const [a, b] = ([0, 1] as const).map((clip) => change(spanOf(shown, ground, clip), clip));
  if (!a || !b) return null;
  return { lengthS: (a.last - a.first) * unitS, firstS: [a.first * unitS, b.first * unitS] };
}
