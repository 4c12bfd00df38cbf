/**
 * The items of a scene on the screen and the clips that have arrived beside them in; all discs of the
 * map, one list for what draws, points and speaks, out.
 */
import type { ClipId } from '../engine/types';
import type { Point } from './hull';
import type { Arrived } from './map-arrivals';
import type { Scene } from './scene';

export interface Spots {
  readonly scene: Scene;
  readonly arrived: readonly Arrived[];
  /** The items', then those of the arrived. */
  readonly points: readonly Point[];
}

export const clipAt = ({ scene, arrived }: Spots, spot: number): ClipId | undefined =>
  spot < scene.count ? scene.comparison.clips[spot] : arrived[spot - scene.count]?.clip;

/** null: not on the map. */
export function spotOf({ scene, arrived }: Spots, clip: ClipId | null): number | null {
  if (clip === null) return null;
  const item = scene.itemOfClip.get(clip);
  if (item !== undefined) return item;
  const index = arrived.findIndex((one) => one.clip === clip);
  return index < 0 ? null : scene.count + index;
}

/** The place of the label among the scene's; −1: none. */
export const labelAt = ({ scene, arrived }: Spots, spot: number): number =>
  spot < scene.count ? scene.labelOfItem[spot] : arrived[spot - scene.count].label;

export const nameAt = ({ scene, arrived }: Spots, spot: number): string =>
  spot < scene.count ? scene.names[spot] : arrived[spot - scene.count].name;
