/**
 * Files given in; clips in the library out. Everything given while files are still being read joins
 * the same batch: one progress, one cancel. A few files are analysed one by one; of many, all are
 * surveyed first, so that they can be compared, and their keyposes follow.
 */
import type { ClipId, ClipSource, ClipSurvey, Engine, EngineError } from '../engine/types';
import type { Analysis } from './analysis';
import type { Backlog } from './backlog';
import { newBatch, stateOf, type Batch, type BatchReport } from './batch';
import { addClips, clipNow, flushClips, patchClipSoon, patchClips } from './clip-changes';
import { isBusy, type Clip } from './clips';
import { failureOf, isAbort } from './failure';
import { isMotionName, takeIn, type Given, type IntakeEvents } from './intake';
import { KnownSources, type Known } from './known-sources';
import type { Store } from './store';

export type { BatchReport } from './batch';

export interface Loader {
  readonly take: (given: readonly Given[]) => Promise<void>;
  readonly add: (sources: readonly ClipSource[]) => Promise<void>;
  readonly cancel: () => void;
}

const tellMs = 60;
/** What is done within a moment needs no progress. */
const quietMs = 300;
/** Files found after the first come into the library together so often. */
const settleInMs = 100;
/** When more files than this wait, they are surveyed. */
const surveyedAbove = 40;
/** Analyses asked of the engine at a time: more than it has workers. */
const atOnce = 12;

export interface LoaderParts {
  readonly engine: Pick<Engine, 'unzip' | 'survey'>;
  readonly store: Store;
  readonly analysis: Pick<Analysis, 'open'>;
  readonly backlog: Pick<Backlog, 'add' | 'hold' | 'cancel'>;
  readonly now: () => number;
  readonly onStart: (id: ClipId) => void;
  /** The work on a clip has ended, well or not. */
  readonly onSettled: (id: ClipId, batchSize: number) => void;
  readonly onEnd: (report: BatchReport) => void;
}

export function createLoader(parts: LoaderParts): Loader {
  return new BatchLoader(parts);
}

class BatchLoader implements Loader {
  private batch: Batch | null = null;
  private timer: ReturnType<typeof setTimeout> | null = null;
  private readonly sources = new KnownSources();
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
    if (!batch) {
      this.parts.backlog.cancel();
      return;
    }
    this.leave();
    batch.abort.abort();
    batch.arriving.clear();
    batch.queue.length = 0;
    this.takeOutUnread(batch);
  }

  /** Runs a search for files in the current batch; the last one out ends the batch. */
  private async within(search: (batch: Batch) => Promise<void>): Promise<void> {
    const batch = (this.batch ??= this.begin());
    batch.searching += 1;
    try {
      await search(batch);
    } catch (error) {
      if (!isAbort(error)) batch.archives.push({ name: '', failure: failureOf(error) });
    }
    batch.searching -= 1;
    this.settleIn(batch);
    this.tell(batch);
    while (batch.pending.size > 0) await Promise.all(batch.pending);
    if (batch.searching === 0 && !batch.ended) this.end(batch);
  }

  private begin(): Batch {
    this.parts.store.reading.value = true;
    this.parts.backlog.hold(true);
    return newBatch(this.parts.now());
  }

  private leave(): void {
    this.batch = null;
    if (this.timer !== null) clearTimeout(this.timer);
    this.timer = null;
    this.parts.store.loading.value = null;
    this.parts.store.reading.value = false;
    this.parts.backlog.hold(false);
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

  /** Takes a file in unless it is there; the first at once, the others in one go with their neighbours. */
  private start(batch: Batch, source: ClipSource): void {
    if (batch.abort.signal.aborted) return;
    const known = this.sources.of(source);
    if (batch.arriving.has(known) || this.isThere(known)) batch.known.push(known);
    else this.arrive(batch, known, source);
    if (batch.clips.length === 0) this.settleIn(batch);
    else batch.timer ??= setTimeout(() => this.settleIn(batch), settleInMs);
  }

  /** Its size is asked for here, one file at a time: the browser may have to ask the disk. */
  private arrive(batch: Batch, known: Known, source: ClipSource): void {
    batch.arriving.set(known, source);
    batch.bytes += source.blob.size;
  }

  private isThere({ id }: Known): boolean {
    const clip = this.clipOf(id);
    return clip !== undefined && !clip.removed && clip.status !== 'failed';
  }

  /** Takes what has arrived into the library; what could not be read before is tried again. */
  private settleIn(batch: Batch): void {
    if (batch.timer !== null) clearTimeout(batch.timer);
    batch.timer = null;
    if (batch.arriving.size === 0) return;
    const { store, onStart } = this.parts;
    const again = [...batch.arriving.keys()].flatMap(({ id }) => id ?? []);
    if (again.length > 0)
      patchClips(
        store,
        again.map((id) => [id, { removed: true }] as const),
      );
    const added = addClips(store, [...batch.arriving.values()]);
    [...batch.arriving.keys()].forEach((known, index) => (known.id = added[index].id));
    batch.arriving.clear();
    for (const { id } of added) {
      batch.clips.push(id);
      batch.queue.push(id);
      onStart(id);
    }
    this.dispatch(batch);
    this.tell(batch);
  }

  private dispatch(batch: Batch): void {
    if (batch.queue.length > surveyedAbove) {
      this.track(batch, this.survey(batch, batch.queue.splice(0)));
    }
    while (batch.opening < atOnce && batch.queue.length > 0) {
      const [id] = batch.queue.splice(0, 1);
      batch.opening += 1;
      this.track(batch, this.open(batch, id));
    }
  }

  private track(batch: Batch, promise: Promise<void>): void {
    const work = promise.finally(() => batch.pending.delete(work));
    batch.pending.add(work);
  }

  private async open(batch: Batch, id: ClipId): Promise<void> {
    try {
      await this.parts.analysis.open(id, batch.abort.signal);
      this.settled(batch, id);
    } catch (error) {
      if (!isAbort(error)) throw error;
    }
    batch.opening -= 1;
    this.dispatch(batch);
  }

  private async survey(batch: Batch, ids: readonly ClipId[]): Promise<void> {
    const items = ids.flatMap((id) => {
      const clip = this.clipOf(id);
      return clip ? [{ id, source: clip.source }] : [];
    });
    const onSurveyed = (some: readonly ClipSurvey[]): void => {
      if (batch.abort.signal.aborted) return;
      for (const one of some) this.accept(batch, one);
    };
    try {
      await this.parts.engine.survey(items, onSurveyed, { signal: batch.abort.signal });
    } catch (error) {
      if (!isAbort(error)) throw error;
    }
  }

  private accept(batch: Batch, survey: ClipSurvey): void {
    const { id, failure, frames, frameTimeS, feature, incomparable } = survey;
    const read = { extent: { frames, frameTimeS }, feature, incomparable };
    patchClipSoon(
      this.parts.store,
      id,
      failure === null
        ? { status: 'surveyed', progress: 1, failure: null, ...read }
        : { status: 'failed', failure },
    );
    if (failure === null) batch.surveyed.push(id);
    this.settled(batch, id);
  }

  private settled(batch: Batch, id: ClipId): void {
    const clip = this.clipOf(id);
    batch.settled.add(id);
    batch.bytesDone += clip?.source.blob.size ?? 0;
    if (clip?.status === 'failed') batch.failed.push(id);
    this.parts.onSettled(id, batch.clips.length);
    this.tell(batch);
  }

  /** An entry of an archive that could not be unpacked: a row with its reason. */
  private refuse(batch: Batch, { fileName, failure }: EngineError): void {
    const { store } = this.parts;
    const end = fileName.lastIndexOf('/');
    const folder = fileName.slice(0, Math.max(0, end));
    const source = { name: fileName.slice(end + 1), folder, blob: new Blob() };
    const [{ id }] = addClips(store, [source]);
    patchClips(store, [[id, { status: 'failed', failure }]]);
    batch.clips.push(id);
    batch.settled.add(id);
    batch.failed.push(id);
  }

  /** Tells how far the batch is, not more often than one can read it. */
  private tell(batch: Batch): void {
    if (this.batch !== batch) return;
    const waitMs = Math.max(tellMs, quietMs - (this.parts.now() - batch.startedMs));
    this.timer ??= setTimeout(() => {
      this.timer = null;
      this.parts.store.loading.value = stateOf(batch, this.parts.now());
    }, waitMs);
  }

  private takeOutUnread(batch: Batch): void {
    const unread = batch.clips.filter((id) => this.isUnread(id));
    if (unread.length === 0) return;
    patchClips(
      this.parts.store,
      unread.map((id) => [id, { removed: true }] as const),
    );
  }

  private end(batch: Batch): void {
    const { store, backlog, onEnd } = this.parts;
    batch.ended = true;
    flushClips(store);
    if (this.batch === batch) this.leave();
    this.takeOutUnread(batch);
    const clips = batch.clips.filter((id) => !this.isUnread(id));
    const cancelled = batch.abort.signal.aborted;
    if (!cancelled) backlog.add(batch.surveyed);
    onEnd({
      cancelled,
      clips,
      failed: batch.failed,
      others: batch.others,
      emptyFolders: batch.emptyFolders,
      archives: batch.archives,
      known: batch.known.flatMap(({ id }) => id ?? []),
    });
  }

  private isUnread(id: ClipId): boolean {
    const clip = this.clipOf(id);
    return clip !== undefined && isBusy(clip);
  }

  private clipOf(id: ClipId | null): Clip | undefined {
    return id === null ? undefined : clipNow(this.parts.store, id);
  }
}
