/**
 * The comparer of the page: a worker of the browser, started by the first comparison.
 */
import { proxy, wrap } from 'comlink';
import { createComparer, type PostureSource } from './comparer';
import type { ComparisonApi } from './comparison-protocol';
import type { Comparer } from './comparison-types';
import type { PoolWorker, Remote } from './pool-task';
import type { WorkerListener } from './protocol';

function spawnComparison(
  listener: WorkerListener,
  died: (message: string) => void,
): PoolWorker<ComparisonApi> {
  const worker = new Worker(new URL('./comparison-script.ts', import.meta.url), {
    type: 'module',
  });
  worker.onerror = (event: Partial<ErrorEvent>) => died(event.message ?? 'it could not start');
  worker.onmessageerror = () => died('a message could not be read');
  const api = wrap<ComparisonApi>(worker) as unknown as Remote<ComparisonApi>;
  void api.listen(proxy(listener));
  return { api, terminate: () => worker.terminate() };
}

export function createBrowserComparer(engine: PostureSource): Comparer {
  return createComparer(engine, spawnComparison);
}
