/** In: performers now and before. Out: whether the camera can stay. */
import type { StagePerformer } from './figure-set';

/** The same recording in the same frame, analysed anew perhaps: the camera may stay where it is. */
export function sameWorld(
  now: readonly StagePerformer[],
  before: readonly StagePerformer[],
): boolean {
  return (
    now.length === before.length &&
    now.every(
      (performer, i) =>
        performer.source.frames === before[i].source.frames &&
        performer.source.jointCount === before[i].source.jointCount &&
        performer.up.axis === before[i].up.axis &&
        performer.groundHeight === before[i].groundHeight &&
        performer.placement === before[i].placement &&
        performer.body.height === before[i].body.height,
    )
  );
}
