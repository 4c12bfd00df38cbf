/**
 * A scene, and where clips have arrived since in; those that are not in it yet, as the map names and
 * marks them, out.
 */
import type { Clip } from '../app/clips';
import type { MapPlace } from '../app/compare-store';
import type { ClipId } from '../engine/types';
import { plainName, type Scene } from './scene';

export interface Arrived {
  readonly clip: ClipId;
  readonly place: MapPlace;
  readonly name: string;
  /** Among the scene's; −1: none. */
  readonly label: number;
}

export function arrivedSince(
  { itemOfClip, labels }: Scene,
  arrivals: ReadonlyMap<ClipId, MapPlace>,
  clips: readonly Clip[],
  labelOf: ReadonlyMap<ClipId, string | null>,
): readonly Arrived[] {
  return [...arrivals].flatMap(([clip, place]) => {
    if (itemOfClip.has(clip)) return [];
    const name = plainName(clips[clip]?.source.name ?? '');
    return [{ clip, place, name, label: labels.indexOf(labelOf.get(clip) ?? '') }];
  });
}
