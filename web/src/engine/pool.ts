/**
 * A pool of workers: tasks go in, their results or one clear error come out. A worker that dies, or
 * does not answer to a cancel, is replaced; only the task that did it fails for it.
 */
import { failureOf } from './failures';
import {
  abortError,
  type Landed,
  type PooledApi,
  type PoolWorker,
  type Remote,
  type Spawn,
  type Task,
  TaskFailed,
  WorkerLost,
} from './pool-task';
import type { JobId, Outcome, WorkerApi, WorkerListener } from './protocol';
import type { ClipId } from './types';

/** A worker that is silent for so long after a cancel is replaced. */
const SILENCE_MS = 200;

/** A task in a worker. */
interface Flight<Api> {
  readonly job: JobId;
  readonly task: Task<unknown, Api>;
  readonly settle: (result: Landed<unknown> | Error) => void;
  /** Its clip was closed meanwhile: the worker goes if its memory has grown above this. */
  retireAbove: number;
}

interface Slot<Api extends PooledApi> {
  readonly index: number;
  worker: PoolWorker<Api> | null;
  readonly flights: Set<Flight<Api>>;
  /** The long task that occupies the slot. */
  long: Flight<Api> | null;
  wasmBytes: number;
  lastUsed: number;
  /** Whether to replace the worker once it has nothing to do. */
  tired: boolean;
}

interface Waiting<Api> {
  readonly slot: number | null;
  readonly task: Task<unknown, Api>;
  readonly settle: (result: Landed<unknown> | Error) => void;
}

export class Pool<Api extends PooledApi = WorkerApi> {
  private readonly spawn: Spawn<Api>;
  private readonly replaced: (slot: number) => void;
  private readonly slots: readonly Slot<Api>[];
  private readonly waiting: Waiting<Api>[] = [];
  private lastJob = 0;
  private uses = 0;
  private destroyed = false;

  /** `replaced` is told of each slot whose worker has ended. */
  constructor(spawn: Spawn<Api>, size: number, replaced: (slot: number) => void = () => undefined) {
    this.spawn = spawn;
    this.replaced = replaced;
    this.slots = Array.from({ length: size }, (_, index) => emptySlot(index));
  }

  /** Starts all workers now, so that the first file does not wait for one. */
  warm(): void {
    for (const slot of this.slots) this.hire(slot);
  }

  /** A long task: one at a time in a slot, the rest wait. In any slot, or in the one named. */
  enqueue<T>(task: Task<T, Api>, slot: number | null = null): Promise<Landed<T>> {
    return this.promise(task, (settle) => {
      const waiting = { slot, task, settle };
      task.signal?.addEventListener('abort', () => this.withdraw(waiting), { once: true });
      this.waiting.push(waiting);
      this.dispatch();
    });
  }

  /** A short task, sent at once to the slot named, also in the middle of a long one. */
  send<T>(task: Task<T, Api>, slot: number): Promise<Landed<T>> {
    return this.promise(task, (settle) => {
      this.launch(this.slotAt(slot), task, settle);
    });
  }

  /** A message without an answer; a slot without a worker has nothing to be told. */
  tell(slot: number, message: (api: Remote<Api>) => Promise<void>): void {
    const { worker } = this.slotAt(slot);
    if (worker !== null) message(worker.api).catch(() => undefined);
  }

  /**
   * A clip was closed: replaces the slot's worker, once it is idle, if its memory has grown above the
   * limit. What is still under way for the clip says so only when it lands.
   */
  retire(slot: number, clip: ClipId, limitBytes: number): void {
    const found = this.slotAt(slot);
    for (const flight of found.flights) {
      if (flight.task.clip === clip) flight.retireAbove = limitBytes;
    }
    this.tireAbove(found, limitBytes);
  }

  /** Whether anything is under way in the slot. */
  isBusy(slot: number): boolean {
    return this.slotAt(slot).flights.size > 0;
  }

  destroy(): void {
    this.destroyed = true;
    for (const waiting of this.waiting.splice(0)) waiting.settle(abortError());
    for (const slot of this.slots) this.dismiss(slot, abortError);
  }

  private promise<T>(
    task: Task<T, Api>,
    start: (settle: (result: Landed<unknown> | Error) => void) => void,
  ): Promise<Landed<T>> {
    return new Promise((resolve, reject) => {
      if (this.destroyed || task.signal?.aborted === true) {
        reject(abortError());
        return;
      }
      start((result) => {
        if (result instanceof Error) reject(result);
        else resolve(result as Landed<T>);
      });
    });
  }

  private withdraw(waiting: Waiting<Api>): void {
    const index = this.waiting.indexOf(waiting);
    if (index < 0) return;
    this.waiting.splice(index, 1);
    waiting.settle(abortError());
  }

  private dispatch(): void {
    const free = this.slots.filter((slot) => slot.long === null && !slot.tired);
    for (const slot of free.sort((a, b) => a.lastUsed - b.lastUsed)) {
      const next = this.take(slot.index);
      if (next === null) continue;
      slot.lastUsed = ++this.uses;
      slot.long = this.launch(slot, next.task, next.settle);
    }
  }

  private take(slot: number): Waiting<Api> | null {
    const fits = (waiting: Waiting<Api>) => waiting.slot === null || waiting.slot === slot;
    const urgent = this.waiting.findIndex((one) => fits(one) && one.task.urgent?.() === true);
    const index = urgent >= 0 ? urgent : this.waiting.findIndex(fits);
    return index < 0 ? null : (this.waiting.splice(index, 1)[0] ?? null);
  }

  private launch(
    slot: Slot<Api>,
    task: Task<unknown, Api>,
    settle: Waiting<Api>['settle'],
  ): Flight<Api> {
    const worker = this.hire(slot);
    const retireAbove = Number.POSITIVE_INFINITY;
    const flight: Flight<Api> = { job: ++this.lastJob, task, settle, retireAbove };
    slot.flights.add(flight);
    task.placed?.(slot.index);
    task.signal?.addEventListener('abort', () => this.cancel(slot, flight), { once: true });
    task.run(worker.api, flight.job).then(
      (outcome) => this.land(slot, flight, outcome),
      (error: unknown) => this.bury(slot, flight, String(error)),
    );
    return flight;
  }

  private land(slot: Slot<Api>, flight: Flight<Api>, outcome: Outcome<unknown>): void {
    if (!slot.flights.has(flight)) return;
    if (outcome.status === 'trapped') {
      this.bury(slot, flight, outcome.message);
      return;
    }
    slot.wasmBytes = outcome.memory.wasmBytes;
    flight.settle(resultOf(outcome, slot.index));
    this.tireAbove(slot, flight.retireAbove);
    this.leave(slot, flight);
  }

  private leave(slot: Slot<Api>, flight: Flight<Api>): void {
    slot.flights.delete(flight);
    if (slot.long === flight) slot.long = null;
    this.rest(slot);
    this.dispatch();
  }

  private tireAbove(slot: Slot<Api>, limitBytes: number): void {
    if (slot.wasmBytes <= limitBytes) return;
    slot.tired = true;
    this.rest(slot);
  }

  private rest(slot: Slot<Api>): void {
    if (slot.tired && slot.flights.size === 0) this.dismiss(slot, () => new WorkerLost());
  }

  private cancel(slot: Slot<Api>, flight: Flight<Api>): void {
    const { worker } = slot;
    if (worker === null || !slot.flights.has(flight)) return;
    flight.settle(abortError());
    let heard = false;
    worker.api.cancel(flight.job).then(
      () => (heard = true),
      () => undefined,
    );
    // The second timer lets an answer in that arrived while this thread was busy.
    setTimeout(
      () =>
        setTimeout(() => {
          const silent = !heard && slot.worker === worker && slot.flights.has(flight);
          if (silent) this.dismiss(slot, () => new WorkerLost());
        }),
      SILENCE_MS,
    );
  }

  /** The worker is dead: the flight that did it fails, the others begin again. */
  private bury(slot: Slot<Api>, culprit: Flight<Api>, message: string): void {
    if (!slot.flights.has(culprit)) return;
    culprit.settle(new TaskFailed(failureOf('worker-died', message)));
    this.dismiss(slot, () => new WorkerLost());
  }

  private died(slot: Slot<Api>, worker: PoolWorker<Api> | null, message: string): void {
    if (slot.worker !== worker) return;
    const [oldest] = slot.flights;
    const culprit = slot.long ?? oldest;
    if (culprit === undefined) this.dismiss(slot, () => new WorkerLost());
    else this.bury(slot, culprit, message);
  }

  /** Ends the worker; its slot gets a new one with the next task. */
  private dismiss(slot: Slot<Api>, reason: () => Error): void {
    slot.worker?.terminate();
    const flights = [...slot.flights];
    Object.assign(slot, emptySlot(slot.index), { lastUsed: slot.lastUsed });
    this.replaced(slot.index);
    for (const flight of flights) flight.settle(reason());
    if (!this.destroyed) this.dispatch();
  }

  private hire(slot: Slot<Api>): PoolWorker<Api> {
    if (slot.worker !== null) return slot.worker;
    const worker = this.spawn(this.listenerOf(slot), (message) => this.died(slot, worker, message));
    slot.worker = worker;
    return worker;
  }

  private listenerOf(slot: Slot<Api>): WorkerListener {
    const taskOf = (job: JobId) => {
      for (const flight of slot.flights) if (flight.job === job) return flight.task;
      return undefined;
    };
    return {
      progress: (job, progress) => taskOf(job)?.progress?.(progress),
      entry: (job, entry) => {
        taskOf(job)?.entry?.(entry);
        return Promise.resolve();
      },
      entryFailure: (job, name, failure) => {
        taskOf(job)?.entryFailure?.(name, failure);
        return Promise.resolve();
      },
    };
  }

  private slotAt(index: number): Slot<Api> {
    const slot = this.slots[index];
    if (slot === undefined) throw new RangeError(`slot ${index} of ${this.slots.length}`);
    return slot;
  }
}

function emptySlot<Api extends PooledApi>(index: number): Slot<Api> {
  return {
    index,
    worker: null,
    flights: new Set(),
    long: null,
    wasmBytes: 0,
    lastUsed: 0,
    tired: false,
  };
}

function resultOf(
  outcome: Exclude<Outcome<unknown>, { status: 'trapped' }>,
  slot: number,
): Landed<unknown> | Error {
  switch (outcome.status) {
    case 'done':
      return { value: outcome.value, slot, memory: outcome.memory };
    case 'failed':
      return new TaskFailed(outcome.failure);
    // Cancelled by another task's cancel: its own has been settled before.
    case 'cancelled':
      return new WorkerLost();
  }
}
