/** The clips of the page and where they stand in; what each of its two stages shows out. */
import type { StagePerformer } from '../stage';
import type { Placement } from '../figure/placement';
import type { PairClip } from './pair-clips';
import type { PoseSources } from './pose-sources';
import { sideYaw, standAlone } from './stands';

export interface StageScene {
  /** Places of the clips shown, among those of the page. */
  readonly places: readonly number[];
  readonly performers: readonly StagePerformer[];
}

export interface SceneWish {
  readonly clips: readonly PairClip[];
  readonly superposed: boolean;
  readonly mirrorB: boolean;
  /** Of superposed clips; null while they are not known. */
  readonly placements: readonly Placement[] | null;
}

const nothingShown: StageScene = { places: [], performers: [] };

/** Of the first stage (0: A, or all) or the second (1: B). */
export function sceneOf(
  stage: 0 | 1,
  wish: SceneWish,
  sources: Pick<PoseSources, 'of'>,
): StageScene {
  const { clips, superposed, placements, mirrorB } = wish;
  if (!superposed) {
    const clip = clips[stage];
    if (!clip) return nothingShown;
    const placement = standAlone(clips[0], clip, mirrorB && stage === 1);
    return { places: [stage], performers: [performerOf(clips[0], clip, placement, sources)] };
  }
  if (stage === 1 || placements?.length !== clips.length) return nothingShown;
  return {
    places: clips.map((_, place) => place),
    performers: clips.map((clip, place) => ({
      ...performerOf(clips[0], clip, placements[place], sources),
      tint: place,
    })),
  };
}

/** It faces as A does, and is seen from where A is. */
function performerOf(
  a: PairClip,
  clip: PairClip,
  placement: Placement,
  sources: Pick<PoseSources, 'of'>,
): StagePerformer {
  const yaws = { sideYawRad: sideYaw(a), frontYawRad: a.performer.frontYawRad };
  return { ...clip.performer, ...yaws, placement, source: sources.of(clip) };
}
