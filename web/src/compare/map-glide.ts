/**
 * Scenes, the clips that have arrived since, and the room in; places of all of them and how they fit
 * the room out, gliding from the old ones to the new. What arrives stands at its place at once, and
 * moves nothing.
 */
import { batch, effect, signal, untracked, type ReadonlySignal } from '@preact/signals-core';
import type { ClipId } from '../engine/types';
import {
  between,
  betweenFits,
  fitMap,
  keptFit,
  type MapRoom,
  type MapTransform,
} from './map-layout';
import type { Arrived } from './map-arrivals';
import type { Scene } from './scene';

const glideMs = 400;

const ease = (part: number): number => 1 - (1 - part) ** 3;

/** Clips, first those of the scene, where each is on the map, and how the map fits the room. */
export interface Laid {
  readonly clips: readonly ClipId[];
  readonly places: Float64Array;
  readonly fit: MapTransform;
}

const noFit: MapTransform = { scale: 1, x: 0, y: 0 };
const nothing: Laid = { clips: [], places: new Float64Array(), fit: noFit };

/** Where the clips of the second lay in the first; those that are new lie at their place at once. */
export function oldPlaces(before: Laid, { clips, places }: Laid): Float64Array {
  const indexOf = new Map(before.clips.map((clip, index) => [clip, index]));
  return places.map((value, k) => {
    const index = indexOf.get(clips[k >> 1]);
    return index === undefined ? value : before.places[2 * index + (k & 1)];
  });
}

const isSame = (a: Float64Array, b: Float64Array): boolean =>
  a.length === b.length && a.every((value, k) => value === b[k]);

export class MapGlide {
  /** Of the items of the scene. */
  readonly places = signal<Float64Array>(nothing.places);
  /** Of those that have arrived. */
  readonly arrivedPlaces = signal<Float64Array>(nothing.places);
  readonly fit = signal<MapTransform>(noFit);
  readonly gliding = signal(false);
  private scene: Scene | null = null;
  private room: MapRoom | null = null;
  private shown = nothing;
  private target = nothing;
  /** Where the glide began. */
  private from = nothing;
  private startMs = 0;
  private run = 0;

  constructor(
    scene: ReadonlySignal<Scene | null>,
    arrived: ReadonlySignal<readonly Arrived[]>,
    room: ReadonlySignal<MapRoom | null>,
  ) {
    effect(() => {
      const [now, came, within] = [scene.value, arrived.value, room.value];
      untracked(() => this.follow(now, came, within));
    });
  }

  private follow(scene: Scene | null, arrived: readonly Arrived[], room: MapRoom | null): void {
    const places = placesOf(scene, arrived);
    const begins = !this.scene || !scene || !room || room !== this.room;
    const { fit } = this.target;
    const fits = room && (begins ? fitMap(places, room.usual) : keptFit(fit, places, room));
    const clips = [...(scene?.comparison.clips ?? []), ...arrived.map(({ clip }) => clip)];
    const target = { clips, places, fit: fits ?? noFit };
    this.scene = scene;
    this.room = room;
    const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
    if (begins || still) this.arrive(target);
    else this.glideTo(target);
  }

  /** A glide under way goes on to where it went if only clips were added. */
  private glideTo(target: Laid): void {
    const isUnderWay = this.gliding.peek() && isSame(oldPlaces(this.target, target), target.places);
    const goesOn = isUnderWay && this.target.fit === target.fit;
    const before = goesOn ? this.from : this.shown;
    const from = { ...before, clips: target.clips, places: oldPlaces(before, target) };
    if (isSame(from.places, target.places) && from.fit === target.fit) return this.arrive(target);
    if (!goesOn) this.startMs = performance.now();
    Object.assign(this, { from, target });
    this.gliding.value = true;
    this.step();
  }

  private readonly step = (): void => {
    cancelAnimationFrame(this.run);
    const { from, target } = this;
    const part = (performance.now() - this.startMs) / glideMs;
    if (part >= 1) return this.arrive(target);
    const places = between(from.places, target.places, ease(part));
    this.show({ ...target, places, fit: betweenFits(from.fit, target.fit, ease(part)) });
    this.run = requestAnimationFrame(this.step);
  };

  private arrive(target: Laid): void {
    cancelAnimationFrame(this.run);
    this.target = target;
    this.show(target);
    this.gliding.value = false;
  }

  private show(shown: Laid): void {
    this.shown = shown;
    const split = 2 * (this.scene?.count ?? 0);
    const [places, arrived] = [shown.places.subarray(0, split), shown.places.subarray(split)];
    batch(() => {
      // What has not moved need not be drawn again.
      if (!isSame(places, this.places.peek())) this.places.value = places;
      if (!isSame(arrived, this.arrivedPlaces.peek())) this.arrivedPlaces.value = arrived;
      this.fit.value = shown.fit;
    });
  }
}

function placesOf(scene: Scene | null, arrived: readonly Arrived[]): Float64Array {
  const map = scene?.comparison.map ?? new Float64Array();
  const places = new Float64Array(map.length + 2 * arrived.length);
  places.set(map);
  arrived.forEach(({ place }, k) => places.set(place, map.length + 2 * k));
  return places;
}
