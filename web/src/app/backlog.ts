/**
 * Clips that are surveyed in; their keyposes and thumbnails, one after another in the background, out.
 * What the person looks at goes first, and is made even when the rest was cancelled.
 */
import { effect } from '@preact/signals-core';
import type { ClipId } from '../engine/types';
import type { Analysis } from './analysis';
import { clipNow, patchClipSoon } from './clip-changes';
import { isAbort } from './failure';
import type { LoadingState, Store } from './store';
import { estimateSecondsLeft } from './time-left';

export interface Backlog {
  readonly add: (ids: readonly ClipId[]) => void;
  /** While files are being read nothing new is begun. */
  readonly hold: (held: boolean) => void;
  /** Leaves what is not done undone. */
  readonly cancel: () => void;
}

export interface BacklogParts {
  readonly store: Store;
  readonly analysis: Pick<Analysis, 'open'>;
  readonly now: () => number;
}

/** Analyses asked of the engine at a time: more than it has workers. */
const atOnce = 12;
const tellMs = 250;

export function createBacklog(parts: BacklogParts): Backlog {
  return new ClipBacklog(parts);
}

class ClipBacklog implements Backlog {
  private readonly parts: BacklogParts;
  private readonly waiting = new Set<ClipId>();
  private readonly underWay = new Map<ClipId, AbortController>();
  private held = false;
  private total = 0;
  private done = 0;
  private startedMs = 0;
  private timer: ReturnType<typeof setTimeout> | null = null;

  constructor(parts: BacklogParts) {
    this.parts = parts;
    const { store } = parts;
    effect(() => {
      for (const id of [store.openId.value, store.compare.otherId.value]) {
        if (id !== null && store.clips.value[id]?.status === 'surveyed') this.begin(id);
      }
    });
  }

  add(ids: readonly ClipId[]): void {
    if (this.waiting.size === 0) Object.assign(this, { total: 0, done: 0 });
    if (this.total === 0) this.startedMs = this.parts.now();
    for (const id of ids) {
      if (clipNow(this.parts.store, id)?.status === 'surveyed') this.waiting.add(id);
    }
    this.total = this.done + this.waiting.size;
    this.goOn();
  }

  hold(held: boolean): void {
    this.held = held;
    this.goOn();
  }

  cancel(): void {
    this.waiting.clear();
    for (const [id, abort] of this.underWay) if (!this.isWatched(id)) abort.abort();
    this.tellNow();
  }

  private goOn(): void {
    if (this.held) return;
    for (const id of this.waiting) {
      if (this.underWay.size >= atOnce) break;
      this.begin(id);
    }
    this.tell();
  }

  private begin(id: ClipId): void {
    this.waiting.delete(id);
    if (this.underWay.has(id) || clipNow(this.parts.store, id)?.removed !== false) return;
    const abort = new AbortController();
    this.underWay.set(id, abort);
    void this.analyse(id, abort.signal).finally(() => {
      this.underWay.delete(id);
      this.done += 1;
      this.goOn();
    });
  }

  private async analyse(id: ClipId, signal: AbortSignal): Promise<void> {
    try {
      await this.parts.analysis.open(id, signal);
    } catch (error) {
      patchClipSoon(this.parts.store, id, { status: 'surveyed' });
      if (!isAbort(error)) throw error;
    }
  }

  private isWatched(id: ClipId): boolean {
    const { openId, compare } = this.parts.store;
    return id === openId.peek() || id === compare.otherId.peek();
  }

  private tell(): void {
    if (!this.held) this.timer ??= setTimeout(() => this.tellNow(), tellMs);
  }

  private tellNow(): void {
    if (this.timer !== null) clearTimeout(this.timer);
    this.timer = null;
    if (!this.held) this.parts.store.loading.value = this.waiting.size > 0 ? this.state() : null;
  }

  private state(): LoadingState {
    const { done, total } = this;
    const elapsedS = (this.parts.now() - this.startedMs) / 1000;
    return {
      stage: 'keyposes',
      total,
      done,
      failed: 0,
      searching: false,
      fraction: done / Math.max(1, total),
      secondsLeft: estimateSecondsLeft(elapsedS, done, total),
    };
  }
}
