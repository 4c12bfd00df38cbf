/**
 * Clips and how they are to run together in; the one time of all of them out. That time is the pair's
 * own, from 0: of each clip it knows the moment. Clip 0 is A, 1 is B; times are seconds of each clip.
 */
import { Chained, Curve, type Rising } from './curve';

export interface ClipLength {
  readonly frames: number;
  readonly frameTimeS: number;
}

/** A path of two clips along each other, in frames of the files. */
export interface WarpingPath {
  readonly pathA: ArrayLike<number>;
  readonly pathB: ArrayLike<number>;
}

export class Alignment {
  readonly durationS: number;
  /** While both A and B run. */
  readonly common: { readonly fromS: number; readonly toS: number };

  constructor(private readonly curves: readonly Rising[]) {
    const both = curves.slice(0, 2);
    this.durationS = Math.max(0, ...curves.map(({ end }) => end));
    const fromS = Math.max(0, ...both.map(({ begin }) => begin));
    this.common = { fromS, toS: Math.max(fromS, Math.min(...both.map(({ end }) => end))) };
  }

  /** The moment of a clip; one that has ended, or not begun, stands still. */
  timeOf(clip: number, pairS: number): number {
    return this.curves[clip]?.at(pairS) ?? 0;
  }

  /** When a moment of a clip comes; of a moment that lasts, the middle. */
  pairTimeOf(clip: number, timeS: number): number {
    return this.curves[clip]?.placeOf(timeS) ?? 0;
  }
}

const lengthS = ({ frames, frameTimeS }: ClipLength): number =>
  Math.max(0, frames - 1) * frameTimeS;

/** All begin at once. */
export function alignedByStart(clips: readonly ClipLength[]): Alignment {
  return alignedAt(
    clips,
    clips.map(() => 0),
  );
}

/** The moments given, one of each clip, come at once. */
export function alignedAt(clips: readonly ClipLength[], momentsS: readonly number[]): Alignment {
  const latest = Math.max(0, ...momentsS);
  const curves = clips.map((clip, i) => {
    const begin = latest - (momentsS[i] ?? 0);
    const length = lengthS(clip);
    return new Curve([begin, begin + length], [0, length]);
  });
  return new Alignment(curves);
}

/**
 * Each clip keeps to the path between A and it; one without a path begins with A. Of A and B neither
 * waits while the other moves: the pair's time is the mean of their times.
 */
export function alignedByPaths(
  clips: readonly ClipLength[],
  paths: readonly (WarpingPath | null)[],
): Alignment {
  const [a, b] = clips;
  const path = paths[1];
  if (!a || !b || !path || path.pathA.length === 0) return alignedByStart(clips);
  const timesA = times(path.pathA, a);
  const timesB = times(path.pathB, b);
  const origin = (timesA[0] + timesB[0]) / 2;
  const pairS = timesA.map((timeS, step) => (timeS + timesB[step]) / 2 - origin);
  const curveA = new Curve(pairS, timesA);
  const others = clips.slice(2).map((clip, i) => {
    const other = paths[i + 2];
    return other
      ? besideA(other, a, clip, curveA)
      : new Curve([0, lengthS(clip)], [0, lengthS(clip)]);
  });
  return new Alignment([curveA, new Curve(pairS, timesB), ...others]);
}

function times(path: ArrayLike<number>, { frameTimeS }: ClipLength): Float64Array {
  return Float64Array.from(path, (frame) => frame * frameTimeS);
}

/** A further clip, by A's time: where A waits for it, it is shown in the middle of its run. */
function besideA(path: WarpingPath, a: ClipLength, clip: ClipLength, curveA: Rising): Rising {
  const places: number[] = [];
  const values: number[] = [];
  for (let step = 0; step < path.pathA.length;) {
    let end = step;
    while (end + 1 < path.pathA.length && path.pathA[end + 1] === path.pathA[step]) end++;
    places.push(path.pathA[step] * a.frameTimeS);
    values.push(((path.pathB[step] + path.pathB[end]) / 2) * clip.frameTimeS);
    step = end + 1;
  }
  return new Chained(new Curve(places, values), curveA);
}
