/**
 * Files given in; clips in the library out. Everything given while files are still being read joins
 * the same batch: one progress, one cancel.
 */
import { batch as together } from '@preact/signals-core';
import type { ClipId, ClipSource, Engine, EngineError, Failure } from '../engine/types';
import type { Analysis } from './analysis';
import { isBusy, isSameSource } from './clips';
import { failureOf, isAbort } from './failure';
import { isMotionName, takeIn, type Given, type IntakeEvents } from './intake';
import { addClip, patchClip, type LoadingState, type Store } from './store';
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

export interface Loader {
  readonly take: (given: readonly Given[]) => Promise<void>;
  readonly add: (sources: readonly ClipSource[]) => Promise<void>;
  readonly cancel: () => void;
}

const tellMs = 60;
/** What is done within a moment needs no progress. */
const quietMs = 300;

interface Batch {
  readonly abort: AbortController;
  readonly startedMs: number;
  readonly clips: ClipId[];
  readonly others: string[];
  readonly emptyFolders: string[];
  readonly archives: { name: string; failure: Failure }[];
  readonly known: ClipId[];
  readonly pending: Set<Promise<void>>;
  searching: number;
  ended: boolean;
}

export interface LoaderParts {
  readonly engine: Pick<Engine, 'unzip'>;
  readonly store: Store;
  readonly analysis: Pick<Analysis, 'open'>;
  readonly now: () => number;
  readonly onStart: (id: ClipId) => void;
  /** The work on a clip has ended, well or not. */
  readonly onSettled: (id: ClipId, batchSize: number) => void;
  readonly onEnd: (report: BatchReport) => void;
}

function newBatch(startedMs: number): Batch {
  return {
    abort: new AbortController(),
    startedMs,
    clips: [],
    others: [],
    emptyFolders: [],
    archives: [],
    known: [],
    pending: new Set(),
    searching: 0,
    ended: false,
  };
}

export function createLoader(parts: LoaderParts): Loader {
  return new BatchLoader(parts);
}

class BatchLoader implements Loader {
  private batch: Batch | null = null;
  private timer: ReturnType<typeof setTimeout> | null = null;
  private readonly parts: LoaderParts;

  constructor(parts: LoaderParts) {
    this.parts = parts;
  }

  take(given: readonly Given[]): Promise<void> {
    return this.within((batch) => takeIn(given, this.eventsOf(batch), batch.abort.signal));
  }

  add(sources: readonly ClipSource[]): Promise<void> {
    return this.within((batch) => {
      for (const source of sources) this.start(batch, source);
      return Promise.resolve();
    });
  }

  /** What is given from now on is a batch of its own, also while the cancelled one still ends. */
  cancel(): void {
    const { batch } = this;
    if (!batch) return;
    this.batch = null;
    if (this.timer !== null) clearTimeout(this.timer);
    this.timer = null;
    batch.abort.abort();
    this.takeOutUnread(batch);
  }

  /** Runs a search for files in the current batch; the last one out ends the batch. */
  private async within(search: (batch: Batch) => Promise<void>): Promise<void> {
    const batch = (this.batch ??= newBatch(this.parts.now()));
    batch.searching += 1;
    try {
      await search(batch);
    } catch (error) {
      if (!isAbort(error)) batch.archives.push({ name: '', failure: failureOf(error) });
    }
    batch.searching -= 1;
    this.tell(batch);
    while (batch.pending.size > 0) await Promise.all(batch.pending);
    if (batch.searching === 0 && !batch.ended) this.end(batch);
  }

  private eventsOf(batch: Batch): IntakeEvents {
    return {
      onSource: (source) => this.start(batch, source),
      onArchive: (archive) => this.unpack(batch, archive),
      onOther: (name) => batch.others.push(name),
      onEmpty: (name) => batch.emptyFolders.push(name),
    };
  }

  private async unpack(batch: Batch, archive: ClipSource): Promise<void> {
    let found = 0;
    const onEntry = (source: ClipSource): void => {
      if (!isMotionName(source.name)) return;
      found += 1;
      this.start(batch, source);
    };
    try {
      const { signal } = batch.abort;
      await this.parts.engine.unzip(archive.blob, onEntry, {
        signal,
        onFailure: (error) => this.refuse(batch, error),
      });
      if (found === 0) batch.emptyFolders.push(archive.name);
    } catch (error) {
      if (!isAbort(error)) batch.archives.push({ name: archive.name, failure: failureOf(error) });
    }
  }

  /** Takes a file into the library unless it is there; one that could not be read is tried again. */
  private start(batch: Batch, source: ClipSource): void {
    if (batch.abort.signal.aborted) return;
    const { store } = this.parts;
    const same = store.present.peek().find((clip) => isSameSource(clip.source, source));
    if (same && same.status !== 'failed') {
      batch.known.push(same.id);
      return;
    }
    if (same) patchClip(store, same.id, { removed: true });
    const { id } = addClip(store, source);
    batch.clips.push(id);
    this.parts.onStart(id);
    const work = this.work(batch, id).finally(() => batch.pending.delete(work));
    batch.pending.add(work);
    this.tell(batch);
  }

  private async work(batch: Batch, id: ClipId): Promise<void> {
    try {
      await this.parts.analysis.open(id, batch.abort.signal);
      this.parts.onSettled(id, batch.clips.length);
    } catch (error) {
      if (!isAbort(error)) throw error;
    }
    this.tell(batch);
  }

  /** An entry of an archive that could not be unpacked: a row with its reason. */
  private refuse(batch: Batch, { fileName, failure }: EngineError): void {
    const { store } = this.parts;
    const end = fileName.lastIndexOf('/');
    const folder = fileName.slice(0, Math.max(0, end));
    const { id } = addClip(store, { name: fileName.slice(end + 1), folder, blob: new Blob() });
    patchClip(store, id, { status: 'failed', failure });
    batch.clips.push(id);
  }

  /** Tells how far the batch is, not more often than one can read it. */
  private tell(batch: Batch): void {
    const waitMs = Math.max(tellMs, quietMs - (this.parts.now() - batch.startedMs));
    this.timer ??= setTimeout(() => {
      this.timer = null;
      if (this.batch === batch) this.parts.store.loading.value = this.stateOf(batch);
    }, waitMs);
  }

  private stateOf(batch: Batch): LoadingState {
    const clips = batch.clips.map((id) => this.parts.store.clips.peek()[id]);
    const done = clips.filter((clip) => !isBusy(clip));
    const bytes = clips.reduce((sum, { source }) => sum + source.blob.size, 0);
    const bytesDone = done.reduce((sum, { source }) => sum + source.blob.size, 0);
    const elapsedS = (this.parts.now() - batch.startedMs) / 1000;
    return {
      total: clips.length,
      done: done.length,
      failed: done.filter(({ status }) => status === 'failed').length,
      searching: batch.searching > 0,
      fraction: bytes > 0 ? bytesDone / bytes : 0,
      secondsLeft: batch.searching > 0 ? null : estimateSecondsLeft(elapsedS, bytesDone, bytes),
    };
  }

  private takeOutUnread(batch: Batch): void {
    const { store } = this.parts;
    const unread = batch.clips.filter((id) => isBusy(store.clips.peek()[id]));
    together(() => {
      for (const id of unread) patchClip(store, id, { removed: true });
      if (this.batch === null) store.loading.value = null;
    });
  }

  private end(batch: Batch): void {
    const { store, onEnd } = this.parts;
    batch.ended = true;
    if (this.batch === batch) this.batch = null;
    this.takeOutUnread(batch);
    const clips = batch.clips.map((id) => store.clips.peek()[id]);
    onEnd({
      cancelled: batch.abort.signal.aborted,
      clips: clips.filter((clip) => !isBusy(clip)).map(({ id }) => id),
      failed: clips.filter(({ status }) => status === 'failed').map(({ id }) => id),
      others: batch.others,
      emptyFolders: batch.emptyFolders,
      archives: batch.archives,
      known: batch.known,
    });
  }
}
