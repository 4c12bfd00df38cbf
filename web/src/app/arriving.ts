/**
 * Clips whose features have come since the latest comparison in; their places on its map out, within a
 * moment and without anything there that moves.
 */
import type { Comparer, MapPlaces } from '../engine/comparison-types';
import type { ClipId } from '../engine/types';
import type { MapPlace } from './compare-store';
import { LatestAnswer } from './latest-answer';
import type { Store } from './store';

/** Clips that come within so long are placed together. */
const placeMs = 20;

export interface ArrivingParts {
  readonly store: Store;
  readonly comparer: Comparer;
  readonly tellError: (error: unknown) => void;
}

export class Arriving {
  private readonly parts: ArrivingParts;
  private readonly answers: LatestAnswer<MapPlaces>;
  private timer: ReturnType<typeof setTimeout> | null = null;

  constructor(parts: ArrivingParts) {
    this.parts = parts;
    this.answers = new LatestAnswer((found) => this.accept(found), parts.tellError);
  }

  /** Places all that the comparison does not cover, soon. */
  place(): void {
    const { store, comparer } = this.parts;
    if (store.compare.comparison.peek() === null) return;
    this.timer ??= setTimeout(() => {
      this.timer = null;
      this.answers.ask(() => comparer.arrivals());
    }, placeMs);
  }

  /** Forgets where these clips arrived. */
  forget(isGone: (clip: ClipId) => boolean): void {
    const { arrivals } = this.parts.store.compare;
    const left = [...arrivals.peek()].filter(([clip]) => !isGone(clip));
    if (left.length < arrivals.peek().size) arrivals.value = new Map(left);
  }

  end(): void {
    if (this.timer !== null) clearTimeout(this.timer);
    this.timer = null;
    this.answers.forget();
  }

  /** Those of before stay too: what shows the comparison may still show an older one. */
  private accept({ clips, places }: MapPlaces): void {
    const { compare, clips: all } = this.parts.store;
    const { arrivals, comparison } = compare;
    if (clips.length === 0 || comparison.peek() === null) return;
    const placed = new Map<ClipId, MapPlace>(arrivals.peek());
    clips.forEach((clip, k) => {
      // It may have been taken out since.
      if (all.peek()[clip]?.removed === false) placed.set(clip, [places[2 * k], places[2 * k + 1]]);
    });
    arrivals.value = placed;
  }
}
