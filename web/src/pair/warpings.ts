/** The clips of the page in; how each runs along A out, as it is found; what is no longer wanted is cancelled. */
import { effect, signal, untracked, type ReadonlySignal } from '@preact/signals-core';
import type { Comparer, Warping } from '../engine/comparison-types';
import type { ClipId, ClipResult } from '../engine/types';
import type { PairClip } from './pair-clips';

export interface Warpings {
  /** By clip; A has none. */
  readonly found: ReadonlySignal<ReadonlyMap<ClipId, Warping>>;
  /** 0 to 1 while B is being warped, else null. */
  readonly progress: ReadonlySignal<number | null>;
  /** Some clip is still to be warped. */
  readonly underWay: ReadonlySignal<boolean>;
  /** Why B could not be warped. */
  readonly failure: ReadonlySignal<unknown>;
  /** Given up until other clips are wanted, or `warp`. */
  readonly cancelled: ReadonlySignal<boolean>;
  readonly cancel: () => void;
  readonly warp: () => void;
  readonly destroy: () => void;
}

export interface WarpingWish {
  readonly clips: readonly PairClip[];
  readonly mirrorB: boolean;
}

/** A clip beside A. */
interface Job {
  readonly isB: boolean;
  readonly id: ClipId;
  readonly a: ClipId;
  readonly results: readonly [ClipResult, ClipResult];
  readonly mirrored: boolean;
}

type Warper = Pick<Comparer, 'warp'>;

export function followWarpings(
  comparer: Warper,
  wish: ReadonlySignal<WarpingWish | null>,
): Warpings {
  return new Following(comparer, wish);
}

class Following implements Warpings {
  readonly found = signal<ReadonlyMap<ClipId, Warping>>(new Map());
  readonly progress = signal<number | null>(null);
  readonly underWay = signal(false);
  readonly failure = signal<unknown>(null);
  readonly cancelled = signal(false);
  readonly destroy: () => void;
  private readonly done = new Map<ClipId, { readonly job: Job; readonly warping: Warping }>();
  private jobs: readonly Job[] = [];
  private abort = new AbortController();

  constructor(
    private readonly comparer: Warper,
    wish: ReadonlySignal<WarpingWish | null>,
  ) {
    const end = effect(() => {
      this.jobs = jobsOf(wish.value);
      untracked(() => this.warp());
    });
    this.destroy = () => {
      end();
      this.abort.abort();
    };
  }

  readonly cancel = (): void => {
    this.abort.abort();
    this.progress.value = null;
    this.underWay.value = false;
    this.cancelled.value = true;
  };

  readonly warp = (): void => {
    this.abort.abort();
    this.abort = new AbortController();
    this.progress.value = this.failure.value = null;
    this.cancelled.value = false;
    for (const [id, { job }] of this.done)
      if (!this.jobs.some((wanted) => wanted.id === id && isSame(wanted, job)))
        this.done.delete(id);
    this.tell();
    void this.run(
      this.jobs.filter(({ id }) => !this.done.has(id)),
      this.abort.signal,
    );
  };

  /** One after the other, B first. */
  private async run(jobs: readonly Job[], abort: AbortSignal): Promise<void> {
    this.underWay.value = jobs.length > 0;
    for (const job of jobs) {
      await this.runOne(job, abort);
      if (abort.aborted) return;
      this.progress.value = null;
    }
    this.underWay.value = false;
  }

  private async runOne(job: Job, abort: AbortSignal): Promise<void> {
    const onProgress = ({ done }: { done: number }): void => {
      if (job.isB && !abort.aborted) this.progress.value = done;
    };
    onProgress({ done: 0 });
    try {
      const settings = { band: null, mirrorB: job.mirrored };
      const warping = await this.comparer.warp(job.a, job.id, settings, {
        signal: abort,
        onProgress,
      });
      if (abort.aborted) return;
      this.done.set(job.id, { job, warping });
      this.tell();
    } catch (error) {
      if (job.isB && !abort.aborted) this.failure.value = error;
    }
  }

  private tell(): void {
    const before = this.found.peek();
    const now = new Map([...this.done].map(([id, { warping }]) => [id, warping] as const));
    const same = now.size === before.size && [...now].every(([id, one]) => before.get(id) === one);
    if (!same) this.found.value = now;
  }
}

function jobsOf(wish: WarpingWish | null): Job[] {
  const [a, ...others] = wish?.clips ?? [];
  return others.map(({ id, result }, i) => ({
    isB: i === 0,
    id,
    a: a.id,
    results: [a.result, result],
    mirrored: i === 0 && wish?.mirrorB === true,
  }));
}

const isSame = (one: Job, other: Job): boolean =>
  one.a === other.a &&
  one.mirrored === other.mirrored &&
  one.results.every((result, i) => result === other.results[i]);
