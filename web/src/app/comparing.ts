/**
 * The comparison follows the store: features of clips in as they become known, what is known of the set
 * out. While files are still being read it is made again as the set grows; at the end it covers all.
 * Meanwhile nothing moves on the map, unless it would show too little: what arrives is placed among what
 * is there, and the end lays out all of it.
 */
import { batch, effect } from '@preact/signals-core';
import type { ClipFeature, Comparer, Comparison, Cut } from '../engine/comparison-types';
import type { ClipId } from '../engine/types';
import { Arriving } from './arriving';
import type { Clip } from './clips';
import { followSelection } from './comparing-selection';
import { isAbort } from './failure';
import { LatestAnswer } from './latest-answer';
import type { Store } from './store';

/** The name under which the browser's timeline notes that all clips are compared. */
const fullMark = 'comparison-full';

/** A set is compared again when it has grown by this factor, … */
const growth = 1.4;
/** … and so many times as long has passed as a comparison takes. */
const restForCost = 4;
/** Changes that come one after the other, as of decisions, are taken together. */
const settleMs = 60;
/** A layout of fewer clips says too little of where others belong: the next comparison lays them out. */
const leastLaidOut = 16;

export interface ComparingParts {
  readonly store: Store;
  readonly comparer: Comparer;
  readonly now: () => number;
  readonly tellError: (error: unknown) => void;
}

/** Returns what ends it. */
export function followComparison(parts: ComparingParts): () => void {
  const comparing = new Comparing(parts);
  const ends = [comparing.start(), followSelection(parts.store, parts.comparer)];
  return () => ends.forEach((end) => end());
}

class Comparing {
  private readonly parts: ComparingParts;
  private readonly told = new Map<ClipId, ClipFeature>();
  /** What was told has changed since the comparison under way, or the last one, began. */
  private changed = false;
  private underWay = false;
  private compared = 0;
  private endedMs = Number.NEGATIVE_INFINITY;
  private costMs = 0;
  private timer: ReturnType<typeof setTimeout> | null = null;
  private dueMs = 0;
  private readonly cuts: LatestAnswer<Cut>;
  private readonly arriving: Arriving;
  /** How many clips the latest layout of the map is of, and whether that is all of the comparison. */
  private laidOut = 0;
  private keepsPlaces = false;

  constructor(parts: ComparingParts) {
    this.parts = parts;
    const { cut } = parts.store.compare;
    this.cuts = new LatestAnswer((found) => (cut.value = found), parts.tellError);
    this.arriving = new Arriving(parts);
  }

  start(): () => void {
    const { store } = this.parts;
    const { settings, cutClusters } = store.compare;
    const ends = [
      effect(() => {
        this.tellFeatures(store.present.value);
        void [store.reading.value, store.openClip.value?.result, store.compare.page.value];
        this.schedule();
      }),
      effect(() => {
        void settings.value;
        if (this.compared === 0) return;
        this.changed = true;
        this.compare();
      }),
      effect(() => {
        const wanted = cutClusters.value;
        const comparison = store.compare.comparison.peek();
        if (comparison) this.cuts.ask(() => this.cutOf(comparison, wanted));
      }),
    ];
    return () => {
      ends.forEach((end) => end());
      if (this.timer !== null) clearTimeout(this.timer);
      this.arriving.end();
    };
  }

  private tellFeatures(present: readonly Clip[]): void {
    const gone = new Set(this.told.keys());
    for (const { id, source, feature } of present) {
      if (feature === null) continue;
      gone.delete(id);
      if (this.told.get(id) === feature) continue;
      this.told.set(id, feature);
      this.parts.comparer.setFeature(id, nameOf(source), feature);
      this.changed = true;
      this.arriving.place();
    }
    for (const id of gone) {
      this.told.delete(id);
      this.parts.comparer.setFeature(id, '', null);
      this.changed = true;
    }
    if (gone.size > 0) this.arriving.forget((id) => gone.has(id));
  }

  /** Compares when it is due, or looks again when it may be. */
  private schedule(): void {
    if (this.told.size < 2) this.clear();
    const isLaidOut = !this.keepsPlaces || this.parts.store.reading.peek();
    if ((!this.changed && isLaidOut) || this.told.size < 2) return;
    const waitMs = this.waitMs();
    if (waitMs === null) return;
    // Not later for what comes meanwhile: features may come without a pause.
    const dueMs = this.parts.now() + waitMs;
    if (this.timer !== null && this.dueMs <= dueMs) return;
    if (this.timer !== null) clearTimeout(this.timer);
    this.dueMs = dueMs;
    this.timer = setTimeout(() => {
      this.timer = null;
      this.compare();
    }, waitMs);
  }

  /** null: not before something else happens. */
  private waitMs(): number | null {
    const { store, now } = this.parts;
    const open = store.openClip.peek();
    const studyWaits = open !== null && open.result === null && open.failure === null;
    if (studyWaits && store.compare.page.peek() === 'study') return null;
    if (!store.reading.peek()) return settleMs;
    if (this.underWay || this.told.size < growth * this.compared) return null;
    return Math.max(settleMs, this.endedMs + restForCost * this.costMs - now());
  }

  private compare(): void {
    const { store, comparer, now } = this.parts;
    const { settings, comparing } = store.compare;
    const startedMs = now();
    const clips = this.told.size;
    this.changed = false;
    this.underWay = true;
    this.keepsPlaces = store.reading.peek() && this.laidOut >= leastLaidOut;
    const { keepsPlaces } = this;
    comparing.value = 0;
    const onProgress = ({ done }: { done: number }): void => {
      comparing.value = done;
    };
    comparer
      .compare(settings.peek(), { onProgress, keepsPlaces })
      .then(async (comparison) => {
        const cut = await this.cutOf(comparison, store.compare.cutClusters.peek());
        this.accept(comparison, cut);
        if (!keepsPlaces) this.laidOut = clips;
        Object.assign(this, { compared: clips, endedMs: now(), costMs: now() - startedMs });
        this.end();
      })
      .catch((error: unknown) => {
        // A newer one is under way.
        if (isAbort(error)) return;
        this.parts.tellError(error);
        this.end();
      });
  }

  private end(): void {
    this.underWay = false;
    this.parts.store.compare.comparing.value = null;
    this.schedule();
  }

  private cutOf({ clips, automaticClusters }: Comparison, wanted: number | null): Promise<Cut> {
    const clusters = Math.min(clips.length, wanted ?? automaticClusters);
    return this.parts.comparer.cut(clusters);
  }

  private accept(comparison: Comparison, cut: Cut): void {
    const { store } = this.parts;
    const before = new Set(store.compare.comparison.peek()?.clips);
    this.cuts.forget();
    batch(() => {
      store.compare.comparison.value = comparison;
      store.compare.cut.value = cut;
      this.arriving.forget((id) => before.has(id));
    });
    if (this.changed) this.arriving.place();
    const isFull = !this.changed && !store.reading.peek() && !this.keepsPlaces;
    if (isFull) performance.mark(fullMark, { detail: comparison.clips.length });
  }

  private clear(): void {
    const { comparison, cut } = this.parts.store.compare;
    if (comparison.peek() === null) return;
    Object.assign(this, { compared: 0, laidOut: 0, keepsPlaces: false });
    this.cuts.forget();
    batch(() => {
      comparison.value = null;
      cut.value = null;
      this.arriving.forget(() => true);
    });
  }
}

/** What exports call a clip. */
function nameOf({ folder, name }: Clip['source']): string {
  return folder === '' ? name : `${folder}/${name}`;
}
