/** A performer's result in; what its rows are drawn from again and again out, computed once. */
import type { KeyposeResult } from '../engine/types';
import { Extremes } from './extremes';

/** Less than a millisecond's work. */
const BLOCKS_AT_ONCE = 500;

export class TimelineData {
  /** Frames of the keyposes, in time order. */
  readonly frames: Int32Array;
  /** Of each candidate, the index of its keypose; -1 for the others. */
  readonly keyposeOf: Int32Array;
  /** Frames to the nearer neighbour of each keypose. */
  readonly gaps: Float64Array;
  readonly largestIntensity: number;
  /** The largest u of any trace. */
  readonly largestStrength: number;
  readonly speed: Extremes;
  readonly trend: Extremes;

  constructor(readonly result: KeyposeResult) {
    this.frames = result.keyposes.map((candidate) => result.candidates[candidate]);
    this.keyposeOf = new Int32Array(result.candidates.length).fill(-1);
    result.keyposes.forEach((candidate, keypose) => {
      this.keyposeOf[candidate] = keypose;
    });
    this.gaps = gapsOf(this.frames);
    this.largestIntensity = largest(result.intensities);
    this.largestStrength = largest(result.traceIntensities);
    this.speed = new Extremes(result.speed);
    this.trend = new Extremes(result.trend);
  }

  /** Builds the caches of the series for some milliseconds; whether they are there. They can do without. */
  build(milliseconds: number): boolean {
    const end = performance.now() + milliseconds;
    for (const series of [this.speed, this.trend]) {
      while (!series.isBuilt) {
        if (performance.now() >= end) return false;
        series.build(BLOCKS_AT_ONCE);
      }
    }
    return true;
  }

  /** The speed at a frame; undefined where there is none. */
  speedAt(frame: number): number | undefined {
    return this.result.speed[frame - this.result.firstFrame];
  }
}

function largest(values: Float64Array): number {
  let most = 0;
  for (const value of values) if (value > most) most = value;
  return most;
}

function gapsOf(frames: Int32Array): Float64Array {
  return Float64Array.from(frames, (frame, index) =>
    Math.min(frame - (frames[index - 1] ?? -Infinity), (frames[index + 1] ?? Infinity) - frame),
  );
}
