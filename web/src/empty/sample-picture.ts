/** A sample of the generator in; what the empty page draws of it out: its speed, its keyposes as figures. */
import { keyposeFrames } from '../app/clips';
import type { ClipId, Engine, KeyposeResult, SampleInfo } from '../engine/types';
import { flatFigure, type FlatFigure } from '../figure/flat-figure';

export interface SamplePicture {
  readonly motion: SampleInfo['motion'];
  readonly keyposes: KeyposeResult;
  /** Frames of the keyposes. */
  readonly frames: Int32Array;
  readonly figures: readonly FlatFigure[];
}

/** Ids below zero never meet those of the library. */
let nextId: ClipId = -1;

export async function drawSample(engine: Engine, info: SampleInfo): Promise<SamplePicture | null> {
  const id = nextId--;
  const result = await engine.open(id, await engine.sample(info.id), {}, {});
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
      motion: info.motion,
      keyposes: performer.keyposes,
      frames,
      figures: Array.from(frames, figure),
    };
  } finally {
    engine.close(id);
  }
}
