/**
 * What the comparison's worker does: features and requests go in, outcomes with arrays to be handed
 * over come out. One set of clips lives here; its comparison made last answers.
 */
import { transfer } from 'comlink';
import type { ComparisonApi, FeatureNews, MapPlan } from './comparison-protocol';
import { unpackFeature } from './comparison-protocol';
import type { ComparisonCore, CoreSet, CoreWork } from './comparison-raw';
import type * as Compare from './comparison-types';
import { CoreFailure } from './core-failure';
import { failureOf } from './failures';
import { buffersOf } from './handing-over';
import type { JobId, Outcome, WorkerListener } from './protocol';
import { Cancelled, Jobs } from './turns';
import type { ClipId } from './types';

/** Progress is told at most so often. */
const PROGRESS_MS = 50;

export class ComparisonWorker implements ComparisonApi {
  private readonly loading: Promise<{ core: ComparisonCore; set: CoreSet }>;
  private readonly jobs = new Jobs();
  private listener: WorkerListener | null = null;
  /** Comparisons are made one after another: the set has room for one. */
  private comparing: Promise<unknown> = Promise.resolve();

  constructor(loading: Promise<ComparisonCore>) {
    this.loading = loading.then((core) => ({ core, set: core.newSet() }));
    this.loading.catch(() => undefined);
  }

  listen(listener: WorkerListener): void {
    this.listener = listener;
  }

  cancel(job: JobId): void {
    this.jobs.cancel(job);
  }

  tell(job: JobId, { clips, names, values, gone }: FeatureNews): Promise<Outcome<null>> {
    return this.outcome(job, (set) => {
      set.removeFeatures(gone);
      clips.forEach((clip, index) => {
        set.setFeature(clip, names[index] ?? '', unpackFeature(values, index, 0));
      });
      return null;
    });
  }

  compare(
    job: JobId,
    settings: Compare.ComparisonSettings,
    { keepsPlaces, known }: MapPlan,
  ): Promise<Outcome<Compare.Comparison>> {
    return this.outcome(job, (set) => {
      const work = this.comparing.then(async () => {
        await this.jobs.turn(job);
        if (known !== null) set.recallPlaces(known);
        set.begin(settings, keepsPlaces);
        await this.steps(job, () => set.step());
        return set.comparison(settings);
      });
      this.comparing = work.catch(() => undefined);
      return work;
    });
  }

  arrivals(job: JobId): Promise<Outcome<Compare.MapPlaces>> {
    return this.outcome(job, (set) => set.arrivals());
  }

  cut(job: JobId, clusters: number): Promise<Outcome<Compare.Cut>> {
    return this.outcome(job, (set) => set.cut(clusters));
  }

  picture(job: JobId, region: Compare.MatrixRegion): Promise<Outcome<Compare.MatrixPicture>> {
    return this.outcome(job, (set) => this.worked(job, set.picture(region)));
  }

  explain(job: JobId, a: ClipId, b: ClipId): Promise<Outcome<Compare.Explanation>> {
    return this.outcome(job, (set) => this.worked(job, set.explain(a, b)));
  }

  neighbours(
    job: JobId,
    clip: ClipId,
    most: number,
  ): Promise<Outcome<readonly Compare.Neighbour[]>> {
    return this.outcome(job, (set) => set.neighbours(clip, most));
  }

  evaluate(job: JobId, labelled: Compare.LabelledCut): Promise<Outcome<Compare.Evaluation>> {
    return this.outcome(job, (set) => this.worked(job, set.evaluate(labelled)));
  }

  exportFile(
    job: JobId,
    kind: Compare.ComparisonExportKind,
    labelled: Compare.LabelledCut,
  ): Promise<Outcome<Blob>> {
    return this.outcome(job, (set) => this.worked(job, set.file(kind, labelled)));
  }

  warp(
    job: JobId,
    a: Compare.PostureSequence,
    b: Compare.PostureSequence,
    settings: Compare.WarpSettings,
  ): Promise<Outcome<Compare.Warping>> {
    return this.outcome(job, (_, core) => this.worked(job, core.newWarping(a, b, settings)));
  }

  /** The result of work that has begun. */
  private async worked<T>(job: JobId, work: CoreWork<T>): Promise<T> {
    try {
      await this.steps(job, () => work.step());
      return work.take();
    } finally {
      work.free();
    }
  }

  /** Steps until one says 1, with a look at messages between whenever it is time. */
  private async steps(job: JobId, step: () => number): Promise<void> {
    let toldMs = performance.now();
    for (let done = 0; done < 1;) {
      while (done < 1 && !this.jobs.isTurnOver()) done = step();
      const now = performance.now();
      if (now - toldMs >= PROGRESS_MS) {
        toldMs = now;
        this.listener?.progress(job, { stage: 'analysing', done });
      }
      if (this.jobs.isTurnOver()) await this.jobs.turn(job);
    }
  }

  private async outcome<T>(
    job: JobId,
    work: (set: CoreSet, core: ComparisonCore) => T | Promise<T>,
  ): Promise<Outcome<T>> {
    this.jobs.begin(job);
    const memory = { wasmBytes: 0, motionBytes: 0 };
    try {
      const { core, set } = await this.ready();
      const value = await work(set, core);
      memory.wasmBytes = core.memoryBytes();
      return transfer({ status: 'done', value, memory }, buffersOf(value));
    } catch (error) {
      if (error instanceof CoreFailure) return { status: 'failed', failure: error.failure, memory };
      if (error instanceof Cancelled) return { status: 'cancelled', memory };
      return { status: 'trapped', message: String(error) };
    } finally {
      this.jobs.end(job);
    }
  }

  private async ready(): Promise<{ core: ComparisonCore; set: CoreSet }> {
    try {
      return await this.loading;
    } catch (error) {
      throw new CoreFailure(failureOf('engine-unavailable', String(error)));
    }
  }
}
