/**
 * The engine of the page: workers of the browser, as many as the page's address or the machine says.
 */
import { proxy, wrap } from 'comlink';
import { createEngine, workerCount } from './engine';
import type { PoolWorker, RemoteWorker } from './pool-task';
import type { WorkerApi, WorkerListener } from './protocol';
import type { Engine } from './types';

/** Starts a worker; `died` is called when it ends by itself. */
export function spawnWorker(listener: WorkerListener, died: (message: string) => void): PoolWorker {
  const worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' });
  // A script that cannot be loaded is an event without a message.
  worker.onerror = (event: Partial<ErrorEvent>) => died(event.message ?? 'it could not start');
  worker.onmessageerror = () => died('a message could not be read');
  const api = wrap<WorkerApi>(worker) as unknown as RemoteWorker;
  void api.listen(proxy(listener));
  return { api, terminate: () => worker.terminate() };
}

/** An engine with workers of the browser; `search` is that of the page's address (`?workers=n`). */
export function createBrowserEngine(search: string): Engine {
  const workers = workerCount(search, navigator.hardwareConcurrency);
  return createEngine({ spawn: spawnWorker, workers });
}
