/**
 * The one door to the workers: clips by their id go in, promises of results come out. A clip lives in
 * one worker; what a worker lost is read again from the clip's Blob when it is next needed.
 */
import type { PostureSequence } from './clip-feature';
import { failureOf } from './failures';
import { MotionMemory } from './motion-memory';
import { Pool } from './pool';
import {
  type Landed,
  type RemoteWorker,
  type Spawn,
  type Task,
  TaskFailed,
  WorkerLost,
  abortError,
} from './pool-task';
import type { ClipRef, JobId, Outcome, SurveyGroup, UnpackedEntry } from './protocol';
import { failedSurveys, surveyGroups, surveysOf } from './survey-groups';
import {
  type ClipId,
  type ClipResult,
  type ClipSource,
  type ClipSurvey,
  type Decisions,
  type Engine,
  EngineError,
  type ExportKind,
  type Failure,
  type MethodOptions,
  type MethodSettings,
  type SampleInfo,
  type SurveyItem,
  type UnzipOptions,
  type WorkOptions,
} from './types';

export interface EngineSettings {
  /** Starts a worker. */
  readonly spawn: Spawn;
  /** Workers; default: by `workerCount`. */
  readonly workers: number;
  /** Motions kept in memory together, in bytes; default 512 MB. */
  readonly motionBytes?: number;
}

/**
 * A worker whose memory has grown above this is replaced when its clip closes or its motion is
 * dropped: memory of WebAssembly never shrinks. 256 MB.
 */
const TIRED_BYTES = 256 * 2 ** 20;

/** How often a task begins again because its worker was replaced for another's sake. */
const ATTEMPTS = 4;

/** As many workers as the page's `?workers=n` says, else one a core, 8 at most. */
export function workerCount(search: string, hardwareConcurrency: number): number {
  const asked = Number(new URLSearchParams(search).get('workers') ?? Number.NaN);
  const count = Number.isInteger(asked) && asked >= 1 ? asked : hardwareConcurrency;
  return Math.max(1, Math.min(count, 8));
}

/** An engine with workers of its own. */
export function createEngine(settings: EngineSettings): Engine {
  return new WorkerEngine(settings);
}

interface OpenClip {
  readonly id: ClipId;
  readonly source: ClipSource;
  decisions: Decisions;
  options: MethodOptions;
  slot: number | null;
  readBefore: boolean;
  /** The analysis under way or done last. */
  run: AbortController;
}

class WorkerEngine implements Engine {
  private readonly pool: Pool;
  private readonly memory: MotionMemory;
  private readonly clips = new Map<ClipId, OpenClip>();

  constructor(settings: EngineSettings) {
    this.pool = new Pool(settings.spawn, settings.workers, (slot) => this.forgetMotions(slot));
    this.memory = new MotionMemory(settings.motionBytes);
    this.pool.warm();
  }

  async open(
    id: ClipId,
    source: ClipSource,
    decisions: Decisions,
    options: MethodOptions,
    work: WorkOptions = {},
  ): Promise<ClipResult> {
    if (this.clips.has(id)) throw new RangeError(`clip ${id} is open already`);
    const run = new AbortController();
    const clip = { id, source, decisions, options, slot: null, readBefore: false, run };
    this.clips.set(id, clip);
    return this.firstAnalysis(clip, work);
  }

  async analyse(
    id: ClipId,
    decisions: Decisions,
    options: MethodOptions,
    work: WorkOptions = {},
  ): Promise<ClipResult> {
    const clip = this.clip(id);
    clip.run.abort();
    Object.assign(clip, { decisions, options, run: new AbortController() });
    return this.analysis(clip, work);
  }

  poses(
    id: ClipId,
    performer: number,
    frames: Int32Array,
    work: WorkOptions = {},
  ): Promise<Float32Array> {
    return this.ask(id, work, (api, job, clip) => api.poses(job, clip, performer, frames));
  }

  poseRange(
    id: ClipId,
    performer: number,
    firstFrame: number,
    count: number,
    work: WorkOptions = {},
  ): Promise<Float32Array> {
    return this.ask(id, work, (api, job, clip) =>
      api.poseRange(job, clip, performer, firstFrame, count),
    );
  }

  postures(id: ClipId, performer: number, work: WorkOptions = {}): Promise<PostureSequence> {
    return this.ask(id, work, (api, job, clip) => api.postures(job, clip, performer));
  }

  async survey(
    items: readonly SurveyItem[],
    onSurveyed: (some: readonly ClipSurvey[]) => void,
    work: WorkOptions = {},
  ): Promise<void> {
    await Promise.all(
      surveyGroups(items).map((group) => this.surveyGroup(group, onSurveyed, work)),
    );
  }

  exportText(id: ClipId, kind: ExportKind, work: WorkOptions = {}): Promise<string> {
    return this.ask(id, work, (api, job, clip) => api.exportText(job, clip, kind));
  }

  async unzip(
    archive: Blob,
    onEntry: (source: ClipSource) => void,
    work: UnzipOptions = {},
  ): Promise<void> {
    const name = archive instanceof File ? archive.name : 'archive';
    const fail = (entry: string, failure: Failure) =>
      work.onFailure?.(new EngineError(failure, entry));
    const task: Task<null> = {
      clip: null,
      signal: work.signal,
      progress: work.onProgress,
      entry: (entry: UnpackedEntry) => onEntry(entry),
      entryFailure: fail,
      run: (api, job) => api.unzip(job, archive),
    };
    // Entries have been handed out: beginning again would hand them out twice.
    await this.pool.enqueue(task).catch((error: unknown) => {
      throw named(error, name);
    });
  }

  async methodDefaults(): Promise<MethodSettings> {
    const task: Task<MethodSettings> = { clip: null, run: (api, job) => api.methodDefaults(job) };
    return (await this.again('defaults', () => this.pool.enqueue(task))).value;
  }

  async samples(): Promise<readonly SampleInfo[]> {
    const task: Task<readonly SampleInfo[]> = { clip: null, run: (api, job) => api.samples(job) };
    return (await this.again('samples', () => this.pool.enqueue(task))).value;
  }

  async sample(id: string): Promise<ClipSource> {
    const task: Task<UnpackedEntry> = { clip: null, run: (api, job) => api.sample(job, id) };
    return (await this.again(id, () => this.pool.enqueue(task))).value;
  }

  keep(id: ClipId | null): void {
    this.memory.keep(id);
  }

  close(id: ClipId): void {
    const clip = this.clips.get(id);
    if (clip === undefined) return;
    this.clips.delete(id);
    this.memory.forget(id);
    clip.run.abort();
    if (clip.slot === null) return;
    this.pool.tell(clip.slot, (api) => api.close(id));
    this.pool.retire(clip.slot, id, TIRED_BYTES);
  }

  destroy(): void {
    this.clips.clear();
    this.pool.destroy();
  }

  /** A worker that dies takes its group along: one by one shows which file it was. */
  private async surveyGroup(
    group: readonly SurveyItem[],
    onSurveyed: (some: readonly ClipSurvey[]) => void,
    { signal }: WorkOptions,
  ): Promise<void> {
    const run = (api: RemoteWorker, job: JobId): Promise<Outcome<SurveyGroup>> =>
      api.survey(job, group);
    const task: Task<SurveyGroup> = { clip: null, signal, run };
    try {
      const { value } = await this.again('', () => this.pool.enqueue(task));
      onSurveyed(surveysOf(value));
    } catch (error) {
      if (!(error instanceof EngineError)) throw error;
      if (error.failure.kind !== 'worker-died' || group.length === 1) {
        onSurveyed(failedSurveys(group, error.failure));
        return;
      }
      await Promise.all(group.map((one) => this.surveyGroup([one], onSurveyed, { signal })));
    }
  }

  /** A clip that could not be opened is forgotten, unless an analysis with other settings follows. */
  private async firstAnalysis(clip: OpenClip, work: WorkOptions): Promise<ClipResult> {
    const { run } = clip;
    try {
      return await this.analysis(clip, work);
    } catch (error) {
      if (this.clips.get(clip.id) === clip && clip.run === run) this.close(clip.id);
      throw error;
    }
  }

  private async analysis(clip: OpenClip, work: WorkOptions): Promise<ClipResult> {
    const own = clip.run.signal;
    const task: Task<ClipResult> = {
      clip: clip.id,
      signal: work.signal === undefined ? own : AbortSignal.any([own, work.signal]),
      progress: work.onProgress,
      urgent: () => this.memory.isKept(clip.id),
      placed: (slot) => (clip.slot = slot),
      run: (api, job) => api.analyse(job, this.refOf(clip)),
    };
    work.onProgress?.({ stage: 'waiting', done: 0 });
    return this.attend(clip, () => this.pool.enqueue(task, clip.slot));
  }

  private async ask<T>(
    id: ClipId,
    work: WorkOptions,
    run: (...parameters: [...Parameters<Task<T>['run']>, ClipRef]) => ReturnType<Task<T>['run']>,
  ): Promise<T> {
    const clip = this.clip(id);
    const { slot } = clip;
    if (slot === null) throw new EngineError(failureOf('not-open'), clip.source.name);
    const task: Task<T> = {
      clip: id,
      signal: work.signal,
      progress: work.onProgress,
      run: (api, job) => run(api, job, this.refOf(clip)),
    };
    return this.attend(clip, () => this.pool.send(task, slot));
  }

  /** The value of a task about a clip; notes what memory the clip holds. */
  private async attend<T>(clip: OpenClip, start: () => Promise<Landed<T>>): Promise<T> {
    const landed = await this.again(clip.source.name, start, () => this.clips.has(clip.id));
    clip.readBefore = true;
    if (this.clips.get(clip.id) !== clip) throw abortError();
    for (const id of this.memory.used(clip.id, landed.memory.motionBytes)) this.dropMotion(id);
    return landed.value;
  }

  /** Starts again as long as the worker was replaced for another task's sake. */
  private async again<T>(
    name: string,
    start: () => Promise<Landed<T>>,
    wanted: () => boolean = () => true,
  ): Promise<Landed<T>> {
    for (let attempt = 1; ; attempt += 1) {
      try {
        return await start();
      } catch (error) {
        if (!(error instanceof WorkerLost) || attempt === ATTEMPTS) throw named(error, name);
        if (!wanted()) throw abortError();
      }
    }
  }

  /** The motions of a slot went with its worker. */
  private forgetMotions(slot: number): void {
    for (const clip of this.clips.values()) if (clip.slot === slot) this.memory.used(clip.id, 0);
  }

  private dropMotion(id: ClipId): void {
    const slot = this.clips.get(id)?.slot ?? null;
    if (slot === null) return;
    this.pool.tell(slot, (api) => api.dropMotion(id));
    // Not under the feet of another clip, which would have to be read again.
    const neighbours = [...this.clips.values()].filter((clip) => clip.slot === slot);
    const isNeeded = neighbours.some((clip) => this.memory.holds(clip.id));
    if (!isNeeded && !this.pool.isBusy(slot)) this.pool.retire(slot, id, TIRED_BYTES);
  }

  private refOf(clip: OpenClip): ClipRef {
    const { id, source, decisions, options, readBefore } = clip;
    return { id, name: source.name, blob: source.blob, decisions, options, readBefore };
  }

  private clip(id: ClipId): OpenClip {
    const clip = this.clips.get(id);
    if (clip === undefined) throw new EngineError(failureOf('not-open'), `clip ${id}`);
    return clip;
  }
}

/** The error as the app sees it: of the file named. */
function named(error: unknown, fileName: string): unknown {
  if (error instanceof TaskFailed) return new EngineError(error.failure, fileName);
  if (error instanceof WorkerLost) return new EngineError(failureOf('worker-died'), fileName);
  return error;
}
