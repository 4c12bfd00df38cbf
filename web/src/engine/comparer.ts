/**
 * The comparison's side of the page: features of clips in, promises of what is known of the set out.
 * There is one worker, started by the first comparison; one that dies is replaced, told the features
 * again, and made to compare again before it answers.
 */
import { transfer } from 'comlink';
import {
  type FeatureNews,
  type ComparisonApi,
  featureLength,
  packFeature,
} from './comparison-protocol';
import type * as Compare from './comparison-types';
import { failureOf } from './failures';
import { Pool } from './pool';
import { type Remote, type Spawn, type Task, TaskFailed, WorkerLost } from './pool-task';
import type { JobId, Outcome } from './protocol';
import { type ClipId, type Engine, EngineError, type WorkOptions } from './types';

/** The one slot of the pool. */
const SLOT = 0;

/** Features told in one message. */
const TOLD_AT_ONCE = 128;

/** How often a request begins again because its worker was replaced. */
const ATTEMPTS = 3;

/** What a comparer needs of the engine. */
export type PostureSource = Pick<Engine, 'postures'>;

export function createComparer(
  engine: PostureSource,
  spawn: Spawn<ComparisonApi>,
): Compare.Comparer {
  return new WorkerComparer(engine, spawn);
}

interface Told {
  readonly name: string;
  readonly feature: Compare.ClipFeature;
}

/** What is to be compared, of which clips. */
interface Wanted {
  readonly settings: Compare.ComparisonSettings;
  readonly clips: ReadonlyMap<ClipId, Told>;
}

/** A comparison with all that is needed to make it again, its map as it lay. */
interface Compared extends Wanted {
  readonly map: Compare.MapPlaces;
}

type Run<T> = Task<T, ComparisonApi>['run'];

class WorkerComparer implements Compare.Comparer {
  private readonly engine: PostureSource;
  private readonly pool: Pool<ComparisonApi>;
  private readonly features = new Map<ClipId, Told>();
  /** What the worker has been told, by clip. */
  private readonly told = new Map<ClipId, Told | undefined>();
  private latest: Compared | null = null;
  /** What the worker has compared: another worker has nothing. */
  private inWorker: Compared | null = null;
  private run = new AbortController();
  /** Only one at a time turns what the worker knows into what it wants. */
  private telling: Promise<unknown> = Promise.resolve();

  constructor(engine: PostureSource, spawn: Spawn<ComparisonApi>) {
    this.engine = engine;
    this.pool = new Pool(spawn, 1, () => this.forget());
  }

  setFeature(clip: ClipId, name: string, feature: Compare.ClipFeature | null): void {
    if (feature === null) this.features.delete(clip);
    else this.features.set(clip, { name, feature });
  }

  async compare(
    settings: Compare.ComparisonSettings,
    { keepsPlaces = false, ...work }: Compare.CompareOptions = {},
  ): Promise<Compare.Comparison> {
    this.run.abort();
    this.run = new AbortController();
    const signal = anyOf(this.run.signal, work.signal);
    return this.comparison({ settings, clips: this.features }, keepsPlaces, { ...work, signal });
  }

  arrivals(): Promise<Compare.MapPlaces> {
    const tellAll = (): Promise<void> => this.inTurn(() => this.tell(this.features));
    return this.ask((api, job) => api.arrivals(job), {}, tellAll);
  }

  cut(clusters: number): Promise<Compare.Cut> {
    return this.ask((api, job) => api.cut(job, clusters));
  }

  picture(region: Compare.MatrixRegion, work?: WorkOptions): Promise<Compare.MatrixPicture> {
    return this.ask((api, job) => api.picture(job, region), work);
  }

  explain(a: ClipId, b: ClipId, work?: WorkOptions): Promise<Compare.Explanation> {
    return this.ask((api, job) => api.explain(job, a, b), work);
  }

  neighbours(clip: ClipId, most: number): Promise<readonly Compare.Neighbour[]> {
    return this.ask((api, job) => api.neighbours(job, clip, most));
  }

  evaluate(labelled: Compare.LabelledCut, work?: WorkOptions): Promise<Compare.Evaluation> {
    return this.ask((api, job) => api.evaluate(job, labelled), work);
  }

  exportFile(
    kind: Compare.ComparisonExportKind,
    labelled: Compare.LabelledCut,
    work?: WorkOptions,
  ): Promise<Blob> {
    return this.ask((api, job) => api.exportFile(job, kind, labelled), work);
  }

  async warp(
    a: ClipId,
    b: ClipId,
    settings: Compare.WarpSettings,
    work: WorkOptions = {},
  ): Promise<Compare.Warping> {
    return this.again(async () => {
      const [one, other] = await Promise.all([this.postures(a, work), this.postures(b, work)]);
      return this.start((api, job) => api.warp(job, one, other, settings), work);
    });
  }

  destroy(): void {
    this.run.abort();
    this.pool.destroy();
  }

  private postures(clip: ClipId, { signal }: WorkOptions) {
    const performer = this.features.get(clip)?.feature.performer ?? 0;
    return this.engine.postures(clip, performer, signal === undefined ? {} : { signal });
  }

  /** A request about the latest comparison. */
  private ask<T>(
    run: Run<T>,
    work: WorkOptions = {},
    prepare = (): Promise<void> => Promise.resolve(),
  ): Promise<T> {
    return this.again(async () => {
      const { latest } = this;
      if (latest !== null && this.inWorker === null) await this.comparison(latest, false);
      await prepare();
      return this.start(run, work);
    });
  }

  private comparison(
    { settings, clips }: Wanted,
    keepsPlaces: boolean,
    work: WorkOptions = {},
  ): Promise<Compare.Comparison> {
    return this.again(async () => {
      const answer = await this.inTurn(async () => {
        await this.tell(clips, work.signal);
        const known = this.inWorker === null ? (this.latest?.map ?? null) : null;
        const plan = { keepsPlaces, known };
        return [this.start((api, job) => api.compare(job, settings, plan), work)] as const;
      });
      const found = await answer[0];
      this.keep(settings, found);
      return found;
    });
  }

  private keep(settings: Compare.ComparisonSettings, { clips, map }: Compare.Comparison): void {
    const toldOf = (clip: ClipId): readonly (readonly [ClipId, Told])[] => {
      const told = this.told.get(clip);
      return told ? [[clip, told]] : [];
    };
    const items = new Map([...clips].flatMap(toldOf));
    this.latest = { settings, clips: items, map: { clips, places: map } };
    this.inWorker = this.latest;
  }

  private inTurn<T>(work: () => Promise<T>): Promise<T> {
    const turn = this.telling.then(work);
    this.telling = turn.catch(() => undefined);
    return turn;
  }

  /** Tells the worker what it does not know yet, a part at a time: packing all takes the page long. */
  private async tell(wanted: ReadonlyMap<ClipId, Told>, signal?: AbortSignal): Promise<void> {
    for (;;) {
      signal?.throwIfAborted();
      const news = newsBetween(this.told, wanted, TOLD_AT_ONCE);
      if (news.clips.length + news.gone.length === 0) return;
      for (const clip of news.gone) this.told.delete(clip);
      for (const clip of news.clips) this.told.set(clip, wanted.get(clip));
      const { buffer } = news.values;
      // Not to be cancelled: what is noted as told has been told.
      await this.start((api, job) => api.tell(job, transfer(news, [buffer])));
    }
  }

  private forget(): void {
    this.told.clear();
    this.inWorker = null;
  }

  private async start<T>(run: Run<T>, work: WorkOptions = {}): Promise<T> {
    const task: Task<T, ComparisonApi> = {
      clip: null,
      signal: work.signal,
      progress: work.onProgress,
      run: (api: Remote<ComparisonApi>, job: JobId): Promise<Outcome<T>> => run(api, job),
    };
    return (await this.pool.send(task, SLOT)).value;
  }

  /** Starts again as long as the worker was replaced for another request's sake. */
  private async again<T>(start: () => Promise<T>): Promise<T> {
    for (let attempt = 1; ; attempt += 1) {
      try {
        return await start();
      } catch (error) {
        if (error instanceof WorkerLost && attempt < ATTEMPTS) continue;
        throw asEngineError(error);
      }
    }
  }
}

/** A worker that died had no file of its own: the comparison is what stopped. */
function asEngineError(error: unknown): unknown {
  if (error instanceof WorkerLost) return new EngineError(failureOf('comparison-stopped'), '');
  if (!(error instanceof TaskFailed)) return error;
  const { failure } = error;
  const died = failure.kind === 'worker-died';
  return new EngineError(died ? failureOf('comparison-stopped', ...failure.details) : failure, '');
}

/** What turns the features told into those wanted, or so many of them at first. */
function newsBetween(
  told: ReadonlyMap<ClipId, Told | undefined>,
  wanted: ReadonlyMap<ClipId, Told>,
  most: number,
): FeatureNews & { readonly values: Float64Array<ArrayBuffer> } {
  const fresh = [...wanted].filter(([clip, one]) => told.get(clip) !== one).slice(0, most);
  const values = new Float64Array(fresh.length * featureLength);
  fresh.forEach(([, { feature }], index) => packFeature(feature, values, index));
  return {
    clips: Int32Array.from(fresh, ([clip]) => clip),
    names: fresh.map(([, { name }]) => name),
    values,
    gone: Int32Array.from([...told.keys()].filter((clip) => !wanted.has(clip))),
  };
}

function anyOf(own: AbortSignal, other: AbortSignal | undefined): AbortSignal {
  return other === undefined ? own : AbortSignal.any([own, other]);
}
