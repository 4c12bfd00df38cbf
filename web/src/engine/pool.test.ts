import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { Pool } from './pool';
import { type PoolWorker, type RemoteWorker, type Spawn, type Task, WorkerLost } from './pool-task';
import type { JobId, Outcome, WorkerListener } from './protocol';

const MEMORY = { wasmBytes: 1000, motionBytes: 0 };

interface FakeWorker {
  readonly worker: PoolWorker;
  readonly listener: WorkerListener;
  readonly cancelled: JobId[];
  terminated: boolean;
  /** Whether it answers to a cancel. */
  answers: boolean;
  die(message: string): void;
}

function fakeWorkers() {
  const workers: FakeWorker[] = [];
  const spawn: Spawn = (listener, died) => {
    const fake: FakeWorker = {
      worker: {
        api: { cancel: (job: JobId) => cancel(job) } as unknown as RemoteWorker,
        terminate: () => (fake.terminated = true),
      },
      listener,
      cancelled: [],
      terminated: false,
      answers: true,
      die: died,
    };
    const cancel = (job: JobId) => {
      fake.cancelled.push(job);
      return fake.answers ? Promise.resolve() : new Promise<void>(() => undefined);
    };
    workers.push(fake);
    return fake.worker;
  };
  return { workers, spawn };
}

/** A task that ends when told to. */
function task(extra: Partial<Task<string>> = {}) {
  const control = { job: 0, slot: -1, end: null as unknown as (outcome: Outcome<string>) => void };
  const made: Task<string> = {
    clip: null,
    placed: (slot) => (control.slot = slot),
    run: (_api, job) =>
      new Promise((resolve) => {
        control.job = job;
        control.end = resolve;
      }),
    ...extra,
  };
  return { made, control };
}

const done = (value: string, memory = MEMORY): Outcome<string> => ({
  status: 'done',
  value,
  memory,
});
const settled = () => new Promise<void>((resolve) => setImmediate(resolve));

describe('pool', () => {
  beforeEach(() => void vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] }));
  afterEach(() => void vi.useRealTimers());

  it('runs one long task in a slot and lets the rest wait', async () => {
    const { workers, spawn } = fakeWorkers();
    const pool = new Pool(spawn, 2);
    const tasks = [task(), task(), task()];
    const results = tasks.map(({ made }) => pool.enqueue(made));
    expect(tasks.map(({ control }) => control.slot)).toEqual([0, 1, -1]);
    tasks[1]?.control.end(done('second'));
    expect((await results[1])?.value).toBe('second');
    expect(tasks[2]?.control.slot).toBe(1);
    expect(workers).toHaveLength(2);
  });

  it('lets an urgent task go first, and a bound one only into its slot', async () => {
    const { spawn } = fakeWorkers();
    const pool = new Pool(spawn, 2);
    const [first, second, bound, plain, urgent] = [
      task(),
      task(),
      task(),
      task(),
      task({ urgent: () => true }),
    ];
    void pool.enqueue(first.made);
    void pool.enqueue(second.made);
    void pool.enqueue(bound.made, 1);
    void pool.enqueue(plain.made);
    void pool.enqueue(urgent.made);
    first.control.end(done(''));
    await settled();
    expect(urgent.control.slot).toBe(0);
    urgent.control.end(done(''));
    await settled();
    expect(plain.control.slot).toBe(0);
    expect(bound.control.slot).toBe(-1);
    second.control.end(done(''));
    await settled();
    expect(bound.control.slot).toBe(1);
  });

  it('sends a short task in the middle of a long one', async () => {
    const { spawn } = fakeWorkers();
    const pool = new Pool(spawn, 1);
    const [long, short] = [task(), task()];
    void pool.enqueue(long.made);
    const result = pool.send(short.made, 0);
    short.control.end(done('pose'));
    expect((await result).value).toBe('pose');
  });

  it('withdraws a waiting task that is cancelled', async () => {
    const { workers, spawn } = fakeWorkers();
    const pool = new Pool(spawn, 1);
    const abort = new AbortController();
    const [long, waiting] = [task(), task({ signal: abort.signal })];
    void pool.enqueue(long.made);
    const result = pool.enqueue(waiting.made);
    abort.abort();
    await expect(result).rejects.toMatchObject({ name: 'AbortError' });
    long.control.end(done(''));
    await settled();
    expect(waiting.control.slot).toBe(-1);
    expect(workers[0]?.cancelled).toEqual([]);
  });

  it('cancels a running task at once and keeps a worker that answers', async () => {
    const { workers, spawn } = fakeWorkers();
    const pool = new Pool(spawn, 1);
    const abort = new AbortController();
    const running = task({ signal: abort.signal });
    const result = pool.enqueue(running.made);
    abort.abort();
    await expect(result).rejects.toMatchObject({ name: 'AbortError' });
    expect(workers[0]?.cancelled).toEqual([running.control.job]);
    await vi.advanceTimersByTimeAsync(1000);
    expect(workers[0]?.terminated).toBe(false);
    const next = task();
    void pool.enqueue(next.made);
    expect(next.control.slot).toBe(-1);
    running.control.end({ status: 'cancelled', memory: MEMORY });
    await settled();
    expect(next.control.slot).toBe(0);
  });

  it('replaces a worker that is silent for 200 ms after a cancel; other tasks begin again', async () => {
    const { workers, spawn } = fakeWorkers();
    const pool = new Pool(spawn, 1);
    const abort = new AbortController();
    const running = task({ signal: abort.signal });
    const cancelled = expect(pool.enqueue(running.made)).rejects.toMatchObject({
      name: 'AbortError',
    });
    const other = expect(pool.send(task().made, 0)).rejects.toBeInstanceOf(WorkerLost);
    const [worker] = workers;
    if (worker !== undefined) worker.answers = false;
    abort.abort();
    await vi.advanceTimersByTimeAsync(190);
    expect(worker?.terminated).toBe(false);
    await vi.advanceTimersByTimeAsync(20);
    expect(worker?.terminated).toBe(true);
    await cancelled;
    await other;
    void pool.enqueue(task().made);
    expect(workers).toHaveLength(2);
  });

  it('blames the task whose worker traps, and no other', async () => {
    const { workers, spawn } = fakeWorkers();
    const replaced = vi.fn();
    const pool = new Pool(spawn, 1, replaced);
    const [guilty, innocent] = [task(), task()];
    const failed = expect(pool.enqueue(guilty.made)).rejects.toMatchObject({
      failure: { kind: 'worker-died', details: ['unreachable'] },
    });
    const lost = expect(pool.send(innocent.made, 0)).rejects.toBeInstanceOf(WorkerLost);
    guilty.control.end({ status: 'trapped', message: 'unreachable' });
    await failed;
    await lost;
    expect(workers[0]?.terminated).toBe(true);
    expect(replaced.mock.calls).toEqual([[0]]);
    innocent.control.end(done('too late'));
    const next = task();
    const result = pool.enqueue(next.made);
    next.control.end(done('alive'));
    expect((await result).value).toBe('alive');
  });

  it('blames the long task when a worker dies without a word', async () => {
    const { workers, spawn } = fakeWorkers();
    const pool = new Pool(spawn, 1);
    const failed = expect(pool.enqueue(task().made)).rejects.toMatchObject({
      failure: { kind: 'worker-died', details: ['out of memory'] },
    });
    const lost = expect(pool.send(task().made, 0)).rejects.toBeInstanceOf(WorkerLost);
    workers[0]?.die('out of memory');
    await failed;
    await lost;
    workers[0]?.die('again');
    void pool.enqueue(task().made);
    expect(workers).toHaveLength(2);
  });

  it('replaces a worker whose memory has grown, once it is idle', async () => {
    const { workers, spawn } = fakeWorkers();
    const pool = new Pool(spawn, 1);
    const [large, busy, waiting] = [task(), task(), task()];
    void pool.enqueue(large.made);
    large.control.end(done('', { wasmBytes: 300, motionBytes: 0 }));
    await settled();
    void pool.enqueue(busy.made);
    pool.retire(0, 7, 400);
    expect(workers[0]?.terminated).toBe(false);
    pool.retire(0, 7, 200);
    void pool.enqueue(waiting.made);
    expect(workers[0]?.terminated).toBe(false);
    busy.control.end(done('', { wasmBytes: 300, motionBytes: 0 }));
    await settled();
    expect(workers[0]?.terminated).toBe(true);
    expect(workers).toHaveLength(2);
    expect(waiting.control.slot).toBe(0);
  });

  it('replaces the worker of a cancelled clip that has grown, when it says so', async () => {
    const { workers, spawn } = fakeWorkers();
    const pool = new Pool(spawn, 1);
    const abort = new AbortController();
    const large = task({ clip: 7, signal: abort.signal });
    const cancelled = expect(pool.enqueue(large.made)).rejects.toMatchObject({
      name: 'AbortError',
    });
    abort.abort();
    await cancelled;
    pool.retire(0, 7, 200);
    expect(workers[0]?.terminated).toBe(false);
    large.control.end({ status: 'cancelled', memory: { wasmBytes: 300, motionBytes: 0 } });
    await settled();
    expect(workers[0]?.terminated).toBe(true);
  });

  it('keeps the worker of another clip that has grown', async () => {
    const { workers, spawn } = fakeWorkers();
    const pool = new Pool(spawn, 1);
    const large = task({ clip: 8 });
    void pool.enqueue(large.made);
    pool.retire(0, 7, 200);
    large.control.end(done('', { wasmBytes: 300, motionBytes: 0 }));
    await settled();
    expect(workers[0]?.terminated).toBe(false);
  });

  it('tells progress to the task whose it is', () => {
    const { workers, spawn } = fakeWorkers();
    const pool = new Pool(spawn, 1);
    const progress = vi.fn();
    const running = task({ progress });
    void pool.enqueue(running.made);
    workers[0]?.listener.progress(running.control.job + 1, { stage: 'reading', done: 0.1 });
    workers[0]?.listener.progress(running.control.job, { stage: 'reading', done: 0.2 });
    expect(progress.mock.calls).toEqual([[{ stage: 'reading', done: 0.2 }]]);
  });

  it('rejects everything when it is destroyed', async () => {
    const { workers, spawn } = fakeWorkers();
    const pool = new Pool(spawn, 1);
    const results = [pool.enqueue(task().made), pool.enqueue(task().made)];
    const rejected = results.map((result) =>
      expect(result).rejects.toMatchObject({ name: 'AbortError' }),
    );
    pool.destroy();
    await Promise.all(rejected);
    expect(workers.map(({ terminated }) => terminated)).toEqual([true]);
    await expect(pool.enqueue(task().made)).rejects.toMatchObject({ name: 'AbortError' });
  });
});
