/** The files given together: what is known of them, how far they are, and how it ended. */
import type { ClipId, ClipSource, Failure } from '../engine/types';
import type { Known } from './known-sources';
import type { LoadingState } from './store';
import { estimateSecondsLeft } from './time-left';

/** What is told when a batch has ended. */
export interface BatchReport {
  readonly cancelled: boolean;
  readonly clips: readonly ClipId[];
  readonly failed: readonly ClipId[];
  /** Names of files given by themselves that are no motions. */
  readonly others: readonly string[];
  readonly emptyFolders: readonly string[];
  readonly archives: readonly { readonly name: string; readonly failure: Failure }[];
  /** Clips that were in the library already. */
  readonly known: readonly ClipId[];
}

export interface Batch {
  readonly abort: AbortController;
  readonly startedMs: number;
  /** Found, and not in the library yet. */
  readonly arriving: Map<Known, ClipSource>;
  timer: ReturnType<typeof setTimeout> | null;
  readonly clips: ClipId[];
  /** In the library, and nothing done about them yet. */
  readonly queue: ClipId[];
  readonly settled: Set<ClipId>;
  readonly surveyed: ClipId[];
  readonly failed: ClipId[];
  readonly others: string[];
  readonly emptyFolders: string[];
  readonly archives: { name: string; failure: Failure }[];
  /** Files that were in the library already. */
  readonly known: Known[];
  readonly pending: Set<Promise<void>>;
  searching: number;
  opening: number;
  bytes: number;
  bytesDone: number;
  ended: boolean;
}

export function newBatch(startedMs: number): Batch {
  return {
    abort: new AbortController(),
    startedMs,
    arriving: new Map(),
    timer: null,
    clips: [],
    queue: [],
    settled: new Set(),
    surveyed: [],
    failed: [],
    others: [],
    emptyFolders: [],
    archives: [],
    known: [],
    pending: new Set(),
    searching: 0,
    opening: 0,
    bytes: 0,
    bytesDone: 0,
    ended: false,
  };
}

export function stateOf(batch: Batch, nowMs: number): LoadingState {
  const { bytes, bytesDone } = batch;
  const elapsedS = (nowMs - batch.startedMs) / 1000;
  return {
    stage: 'reading',
    total: batch.clips.length,
    done: batch.settled.size,
    failed: batch.failed.length,
    searching: batch.searching > 0,
    fraction: bytes > 0 ? bytesDone / bytes : 0,
    secondsLeft: batch.searching > 0 ? null : estimateSecondsLeft(elapsedS, bytesDone, bytes),
  };
}
