/**
 * What a worker does: requests about clips go in, outcomes with arrays to be handed over come out.
 * Every request carries all that is needed to begin again, so that nothing depends on its history.
 */
import { transfer } from 'comlink';
import type { PostureSequence } from './clip-feature';
import { failureOf } from './failures';
import { failureIn, readingError } from './failure-in';
import { buffersOf } from './handing-over';
import { HeldClip } from './held-clip';
import type {
  ClipRef,
  JobId,
  Memory,
  Outcome,
  SurveyGroup,
  UnpackedEntry,
  WorkerApi,
  WorkerListener,
} from './protocol';
import { CoreFailure } from './core-failure';
import type { Core } from './raw';
import { slicesOf } from './slices';
import { posturesOf, surveyAll } from './survey';
import { Cancelled, Jobs } from './turns';
import type {
  ClipId,
  ClipResult,
  ExportKind,
  MethodSettings,
  Progress,
  SampleInfo,
  SurveyItem,
} from './types';
import { unzipMotions } from './unzip';

/** Progress is told at most so often. */
const PROGRESS_MS = 50;

/** The part of the whole work on a clip that reading is. */
const READING_PART = 0.5;

/** A reading that serves every request is not cancelled with one of them. */
const NOBODYS_JOB: JobId = 0;

export class ClipWorker implements WorkerApi {
  private readonly loading: Promise<Core>;
  private readonly jobs = new Jobs();
  private readonly clips = new Map<ClipId, HeldClip>();
  private listener: WorkerListener | null = null;
  private lastProgress = 0;

  constructor(loading: Promise<Core>) {
    this.loading = loading;
    loading.catch(() => undefined);
  }

  listen(listener: WorkerListener): void {
    this.listener = listener;
  }

  analyse(job: JobId, clip: ClipRef): Promise<Outcome<ClipResult>> {
    return this.withClip(job, clip, (held) =>
      held.inTurn(async () => {
        await this.ensureMotion(job, clip, held);
        await this.runAnalysis(job, clip, held);
        const result = held.core.result();
        held.thumbnails = result.performers.map(({ thumbnailFrame: frame }, performer) => ({
          frame,
          pose: held.core.poses(performer, Int32Array.of(frame)),
        }));
        const thumbnailPose = held.thumbnails[0]?.pose.slice() ?? new Float32Array();
        return { ...result, thumbnailPose };
      }),
    );
  }

  poses(
    job: JobId,
    clip: ClipRef,
    performer: number,
    frames: Int32Array,
  ): Promise<Outcome<Float32Array>> {
    return this.withClip(job, clip, async (held) => {
      const thumbnail = held.thumbnails[performer];
      if (frames.length === 1 && frames[0] === thumbnail?.frame) return thumbnail.pose.slice();
      await this.ensureMotion(NOBODYS_JOB, clip, held);
      return held.core.poses(performer, frames);
    });
  }

  poseRange(
    job: JobId,
    clip: ClipRef,
    performer: number,
    firstFrame: number,
    count: number,
  ): Promise<Outcome<Float32Array>> {
    return this.withClip(job, clip, async (held) => {
      await this.ensureMotion(NOBODYS_JOB, clip, held);
      return held.core.poseRange(performer, firstFrame, count);
    });
  }

  postures(job: JobId, clip: ClipRef, performer: number): Promise<Outcome<PostureSequence>> {
    return this.withClip(job, clip, (held) =>
      held.inTurn(async () => {
        await this.ensureMotion(job, clip, held);
        if (held.analysedAs !== settingsKey(clip)) {
          held.analysedAs = null;
          held.core.beginAnalysis(clip.decisions, clip.options);
        }
        await this.steps(job, () => held.core.stepSurvey());
        return posturesOf(held.core, performer);
      }),
    );
  }

  survey(job: JobId, clips: readonly SurveyItem[]): Promise<Outcome<SurveyGroup>> {
    return this.outcome(job, null, (core) =>
      surveyAll(core, clips, (step) => this.steps(job, step)),
    );
  }

  exportText(job: JobId, clip: ClipRef, kind: ExportKind): Promise<Outcome<string>> {
    return this.withClip(job, clip, (held) =>
      held.inTurn(async () => {
        if (held.analysedAs !== settingsKey(clip)) {
          await this.ensureMotion(job, clip, held);
          await this.runAnalysis(job, clip, held);
        }
        held.sha256 ??= await this.digest(job, clip.blob);
        return held.core.report(kind, clip.name, held.sha256);
      }),
    );
  }

  unzip(job: JobId, archive: Blob): Promise<Outcome<null>> {
    return this.outcome(job, null, async () => {
      await unzipMotions(archive, {
        entry: async (entry) => this.listener?.entry(job, entry),
        entryFailure: async (name, failure) => this.listener?.entryFailure(job, name, failure),
        progress: (done) => this.tell(job, { stage: 'reading', done }),
        turn: () => this.jobs.turn(job),
      });
      return null;
    });
  }

  methodDefaults(job: JobId): Promise<Outcome<MethodSettings>> {
    return this.outcome(job, null, (core) => Promise.resolve(core.methodDefaults));
  }

  samples(job: JobId): Promise<Outcome<readonly SampleInfo[]>> {
    return this.outcome(job, null, (core) => Promise.resolve(core.samples));
  }

  sample(job: JobId, id: string): Promise<Outcome<UnpackedEntry>> {
    return this.outcome(job, null, (core) => {
      const name = core.samples.find((sample) => sample.id === id)?.fileName ?? id;
      const bytes = core.sample(id);
      if (bytes === null) throw new CoreFailure(failureOf('no-such-sample', id));
      return Promise.resolve({ name, folder: '', blob: new Blob([bytes]) });
    });
  }

  cancel(job: JobId): void {
    this.jobs.cancel(job);
  }

  dropMotion(id: ClipId): void {
    this.clips.get(id)?.dropMotion();
  }

  close(id: ClipId): void {
    this.clips.get(id)?.close();
    this.clips.delete(id);
  }

  private withClip<T>(
    job: JobId,
    clip: ClipRef,
    work: (held: HeldClip) => Promise<T>,
  ): Promise<Outcome<T>> {
    return this.outcome(job, clip.id, (core) => {
      const held = this.clips.get(clip.id) ?? new HeldClip(core);
      this.clips.set(clip.id, held);
      return held.use(() => work(held));
    });
  }

  private async outcome<T>(
    job: JobId,
    clip: ClipId | null,
    work: (core: Core) => Promise<T>,
  ): Promise<Outcome<T>> {
    this.jobs.begin(job);
    try {
      const value = await work(await this.core());
      const memory = await this.memory(clip);
      return transfer({ status: 'done', value, memory }, buffersOf(value));
    } catch (error) {
      return this.failed(error, clip);
    } finally {
      this.jobs.end(job);
    }
  }

  private async failed(error: unknown, clip: ClipId | null): Promise<Outcome<never>> {
    const failure = failureIn(error);
    if (failure !== null) return { status: 'failed', failure, memory: await this.memory(clip) };
    if (error instanceof Cancelled) {
      return { status: 'cancelled', memory: await this.memory(clip) };
    }
    // Anything else is the module's trap or a fault of this code: the worker is not to be trusted.
    return { status: 'trapped', message: String(error) };
  }

  private async core(): Promise<Core> {
    try {
      return await this.loading;
    } catch (error) {
      throw new CoreFailure(failureOf('engine-unavailable', String(error)));
    }
  }

  private async memory(clip: ClipId | null): Promise<Memory> {
    const core = await this.loading.catch(() => null);
    const held = clip === null ? undefined : this.clips.get(clip);
    return { wasmBytes: core?.memoryBytes() ?? 0, motionBytes: held?.motionBytes ?? 0 };
  }

  private async ensureMotion(job: JobId, clip: ClipRef, held: HeldClip): Promise<void> {
    while (!held.core.hasMotion()) {
      held.reading ??= this.read(job, clip, held).finally(() => (held.reading = null));
      await held.reading;
    }
  }

  private async read(job: JobId, clip: ClipRef, held: HeldClip): Promise<void> {
    const total = clip.blob.size;
    held.core.beginReading(total);
    let read = 0;
    try {
      for await (const slice of slicesOf(clip.blob)) {
        held.core.push(slice);
        read += slice.length;
        this.tell(job, { stage: 'reading', done: (READING_PART * read) / total });
        await this.jobs.turn(job);
      }
    } catch (error) {
      throw readingError(error, clip.readBefore);
    }
    held.core.endReading();
  }

  private async runAnalysis(job: JobId, clip: ClipRef, held: HeldClip): Promise<void> {
    held.core.beginAnalysis(clip.decisions, clip.options);
    held.analysedAs = null;
    await this.steps(
      job,
      () => held.core.step(),
      (done) => {
        const whole = READING_PART + (1 - READING_PART) * done;
        this.tell(job, { stage: 'analysing', done: whole });
      },
    );
    await this.jobs.turn(job);
    held.analysedAs = settingsKey(clip);
  }

  /** Steps until one says 1, with a look at messages between whenever it is time. */
  private async steps(
    job: JobId,
    step: () => number,
    tell: (done: number) => void = () => undefined,
  ): Promise<void> {
    for (let done = 0; done < 1;) {
      while (done < 1 && !this.jobs.isTurnOver()) done = step();
      tell(done);
      if (this.jobs.isTurnOver()) await this.jobs.turn(job);
    }
  }

  private async digest(job: JobId, blob: Blob): Promise<string> {
    const digest = (await this.loading).newDigest();
    try {
      for await (const slice of slicesOf(blob)) {
        digest.push(slice);
        await this.jobs.turn(job);
      }
      return digest.hexadecimal();
    } catch (error) {
      throw readingError(error, true);
    } finally {
      digest.free();
    }
  }

  private tell(job: JobId, progress: Progress): void {
    const now = performance.now();
    if (now - this.lastProgress < PROGRESS_MS && progress.done < 1) return;
    this.lastProgress = now;
    this.listener?.progress(job, progress);
  }
}

/** Tells settings apart. */
function settingsKey({ decisions, options }: ClipRef): string {
  return JSON.stringify([decisions, options]);
}
