/** A sample motion in; what the empty page draws of it out: its speed, its keyposes as figures. */
import { keyposeFrames } from '../app/clips';
import type { ClipId, Engine, KeyposeResult, SampleInfo } from '../engine/types';
import { flatFigure, type FlatFigure } from '../figure/flat-figure';

/** In the order in which they are offered; the generator's ids. */
export const sampleMotions = [
  'slow-dance',
  'tired-dance',
  'walk',
  'run',
] as const satisfies readonly SampleInfo['motion'][];

export interface SamplePicture {
  readonly motion: SampleInfo['motion'];
  readonly keyposes: KeyposeResult;
  /** Frames of the keyposes. */
  readonly frames: Int32Array;
  readonly figures: readonly FlatFigure[];
}

/** Ids below zero never meet those of the library. */
let nextId: ClipId = -1;

export async function drawSample(
  engine: Engine,
  motion: SampleInfo['motion'],
): Promise<SamplePicture | null> {
  const id = nextId--;
  const result = await engine.open(id, await engine.sample(motion), {}, {});
  try {
    const performer = result.performers[0];
    if (!performer?.keyposes) return null;
    const frames = keyposeFrames(performer);
    const poses = await engine.poses(id, 0, frames);
    const width = performer.skeleton.parents.length * 3;
    const figure = (_: number, index: number): FlatFigure =>
      flatFigure(
        poses.subarray(index * width, (index + 1) * width),
        performer,
        performer.sideYawRad,
      );
    return {
      motion,
      keyposes: performer.keyposes,
      frames,
      figures: Array.from(frames, figure),
    };
  } finally {
    engine.close(id);
  }
}
