/**
 * What goes into a pool of workers and what comes out: workers, tasks, results, and the two errors that
 * are no result.
 */
import type { JobId, Memory, Outcome, UnpackedEntry, WorkerApi, WorkerListener } from './protocol';
import type { ClipId, Failure, Progress } from './types';

/** What every worker of a pool understands. */
export interface PooledApi {
  listen(listener: WorkerListener): void;
  cancel(job: JobId): void;
}

/** A worker as seen from outside: every answer is a promise. */
export type Remote<Api> = {
  readonly [K in keyof Api]: Api[K] extends (...parameters: infer P) => infer R
    ? (...parameters: P) => Promise<Awaited<R>>
    : never;
};

export type RemoteWorker = Remote<WorkerApi>;

/** A worker and its life. */
export interface PoolWorker<Api extends PooledApi = WorkerApi> {
  readonly api: Remote<Api>;
  terminate(): void;
}

/** Starts a worker; `died` is called when it ends by itself. */
export type Spawn<Api extends PooledApi = WorkerApi> = (
  listener: WorkerListener,
  died: (message: string) => void,
) => PoolWorker<Api>;

export interface Task<T, Api = WorkerApi> {
  readonly clip: ClipId | null;
  readonly signal?: AbortSignal | undefined;
  /** Whether to go before the tasks that wait. */
  readonly urgent?: () => boolean;
  /** Told in which slot the task runs. */
  readonly placed?: (slot: number) => void;
  readonly progress?: ((progress: Progress) => void) | undefined;
  readonly entry?: (entry: UnpackedEntry) => void;
  readonly entryFailure?: (name: string, failure: Failure) => void;
  run(api: Remote<Api>, job: JobId): Promise<Outcome<T>>;
}

export interface Landed<T> {
  readonly value: T;
  readonly slot: number;
  readonly memory: Memory;
}

/** The task failed for a reason of its own. */
export class TaskFailed extends Error {
  readonly failure: Failure;

  constructor(failure: Failure) {
    super(failure.kind);
    this.name = 'TaskFailed';
    this.failure = failure;
  }
}

/** The worker was replaced for another task's sake: begin again. */
export class WorkerLost extends Error {
  constructor() {
    super('the worker was replaced');
    this.name = 'WorkerLost';
  }
}

/** The error of a cancelled promise. */
export function abortError(): DOMException {
  return new DOMException('The work was cancelled.', 'AbortError');
}
