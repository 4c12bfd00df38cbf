/** A selected clip in; the flat figures of its strip out, as soon as their poses have come. */
import { computed, type ReadonlySignal } from '@preact/signals-core';
import type { Clip } from '../app/clips';
import { follow } from '../common/mount';
import type { ClipResult, Engine, PerformerResult } from '../engine/types';
import { flatFigure, type FlatFigure } from '../figure/flat-figure';
import { createKeyposePoses, type PoseOwner } from '../study/keypose-poses';
import { stripFrames } from './strip-figures';

interface Drawn {
  readonly owner: PoseOwner;
  readonly performer: PerformerResult;
  readonly frames: Int32Array;
}

function drawnOf(clip: Clip | null): Drawn | null {
  const result: ClipResult | null = clip?.result ?? null;
  const index = clip?.feature?.performer ?? 0;
  const performer = result?.performers[index];
  if (!clip || !result || !performer) return null;
  return {
    owner: { id: clip.id, performer: index, jointCount: performer.skeleton.parents.length },
    performer,
    frames: stripFrames(result, performer),
  };
}

/** Until the clip has been analysed its thumbnail, if there is one, stands for it. */
export function createClipFigures(
  engine: Pick<Engine, 'poses'>,
  clip: ReadonlySignal<Clip | null>,
): ReadonlySignal<readonly FlatFigure[]> {
  const poses = createKeyposePoses(engine);
  const drawn = computed(() => drawnOf(clip.value));
  follow(() => {
    if (drawn.value) poses.want(drawn.value.owner, drawn.value.frames);
  });
  return computed(() => {
    const thumbnail = clip.value?.thumbnail;
    if (!drawn.value) return thumbnail ? [thumbnail] : [];
    const { owner, performer, frames } = drawn.value;
    const arrived = poses.of(owner);
    return [...frames].flatMap((frame) => {
      const pose = arrived.get(frame);
      return pose ? [flatFigure(pose, performer, performer.sideYawRad)] : [];
    });
  });
}
