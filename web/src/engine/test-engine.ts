/**
 * For tests: the core from the generated files, and workers that live in this thread, behind the same
 * messages as real ones.
 */
import { readFile } from 'node:fs/promises';
import { expose, proxy, wrap } from 'comlink';
import { ClipWorker } from './clip-worker';
import type { ComparisonApi } from './comparison-protocol';
import { type ComparisonCore, loadComparisonCore } from './comparison-raw';
import { ComparisonWorker } from './comparison-worker';
import type { PooledApi, PoolWorker, Remote, Spawn } from './pool-task';
import type { WorkerApi } from './protocol';
import { type Core, loadCore } from './raw';

const comparisonFile = new URL('./generated/comparison_wasm_bg.wasm', import.meta.url);
const wasmFile = new URL('./generated/motion_wasm_bg.wasm', import.meta.url);

/** The core of this thread. */
export async function testCore(): Promise<Core> {
  return loadCore(new Uint8Array(await readFile(wasmFile)));
}

/** The core of comparing of this thread. */
export async function testComparisonCore(): Promise<ComparisonCore> {
  return loadComparisonCore(new Uint8Array(await readFile(comparisonFile)));
}

/** Starts a worker in this thread around `core`. */
export function spawnAround(core: Core): Spawn {
  return spawnInThread<WorkerApi>(() => new ClipWorker(Promise.resolve(core)));
}

/** The same for comparing. */
export function spawnComparisonAround(core: ComparisonCore): Spawn<ComparisonApi> {
  return spawnInThread<ComparisonApi>(() => new ComparisonWorker(Promise.resolve(core)));
}

function spawnInThread<Api extends PooledApi>(start: () => Api): Spawn<Api> {
  return (listener): PoolWorker<Api> => {
    const { port1, port2 } = new MessageChannel();
    expose(start(), port1);
    port1.start();
    const api = wrap<Api>(port2) as unknown as Remote<Api>;
    port2.start();
    void (api as unknown as Remote<PooledApi>).listen(proxy(listener));
    return {
      api,
      terminate: () => {
        port1.close();
        port2.close();
      },
    };
  };
}
