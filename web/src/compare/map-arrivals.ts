/**
 * A scene, and where clips have arrived since in; those that are not in it yet, as the map names and
 * marks them, out.
 */
import type { MapPlace } from '../app/compare-store';
import type { ClipId } from '../engine/types';
import type { Scene } from './scene';

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
  nameOf: (clip: ClipId) => string,
  labelOf: ReadonlyMap<ClipId, string | null>,
): readonly Arrived[] {
  return [...arrivals].flatMap(([clip, place]) => {
    if (itemOfClip.has(clip)) return [];
    const label = labels.indexOf(labelOf.get(clip) ?? '');
    return [{ clip, place, name: nameOf(clip), label }];
  });
}
