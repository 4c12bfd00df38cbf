/** A synthetic result of any length, for the tests of the timeline. */
import type { KeyposeResult } from '../engine/types';

export interface Size {
  readonly frames: number;
  readonly candidates: number;
  readonly keyposes: number;
}

const SCALES = 72;

type Traces = Pick<
  KeyposeResult,
  'traceOffsets' | 'traceScales' | 'traceFrames' | 'traceIntensities' | 'tracePlaces'
>;

/** Traces of these lengths, each leaning to the right and growing weaker. */
function tracesOf(candidates: Int32Array, lengths: Int32Array): Traces {
  const traceOffsets = new Int32Array(candidates.length + 1);
  lengths.forEach((length, c) => (traceOffsets[c + 1] = traceOffsets[c] + length));
  const points = traceOffsets[candidates.length];
  const [scales, frames] = [new Int32Array(points), new Int32Array(points)];
  const [strengths, places] = [new Float64Array(points), new Float64Array(points)];
  candidates.forEach((frame, c) => {
    for (let scale = 0; scale < lengths[c]; scale++) {
      const point = traceOffsets[c] + scale;
      scales[point] = scale;
      places[point] = frame + 0.4 * scale;
      frames[point] = Math.round(places[point]);
      strengths[point] = 1 / (1 + scale);
    }
  });
  return {
    traceOffsets,
    traceScales: scales,
    traceFrames: frames,
    traceIntensities: strengths,
    tracePlaces: places,
  };
}

/** Candidates evenly spread; every nth is a keypose, with a longer trace and more intensity. */
export function testResult({ frames, candidates, keyposes }: Size): KeyposeResult {
  const place = (candidate: number): number => Math.floor((candidate * keyposes) / candidates);
  const isKeypose = (candidate: number): boolean => place(candidate + 1) > place(candidate);
  const all = Int32Array.from({ length: candidates }, (_, c) => c);
  const at = all.map((c) => Math.floor(((c + 0.5) * frames) / candidates));
  const lengths = all.map((c) => (isKeypose(c) ? 20 + (c % 50) : c % 8));
  return {
    speed: Float64Array.from({ length: frames }, (_, n) => 2 + Math.sin(n / 20)),
    firstFrame: 0,
    trend: new Float64Array(frames).fill(2),
    maximumSpeed: 3,
    scalesHz: Float64Array.from({ length: SCALES }, (_, index) => 8 * 0.95 ** index),
    candidates: at,
    intensities: Float64Array.from(all, (c) => (isKeypose(c) ? 10 + (c % 20) : lengths[c] && 0.5)),
    ...tracesOf(at, lengths),
    byIntensity: new Int32Array(),
    strongestScales: new Int32Array(),
    keyposes: all.filter(isKeypose),
    bodyPartPercents: new Float64Array(),
    postures: [],
    clusters: 2,
    anova: null,
    sureness: 2,
    cut: 5,
  };
}
