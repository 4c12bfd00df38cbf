/**
 * For tests: the core from the generated files, and workers that live in this thread, behind the same
 * messages as real ones.
 */
import { readFile } from 'node:fs/promises';
import { expose, proxy, wrap } from 'comlink';
import { ClipWorker } from './clip-worker';
import type { PoolWorker, RemoteWorker, Spawn } from './pool-task';
import type { WorkerApi } from './protocol';
import { type Core, loadCore } from './raw';

const wasmFile = new URL('./generated/motion_wasm_bg.wasm', import.meta.url);

/** The core of this thread. */
export async function testCore(): Promise<Core> {
  return loadCore(new Uint8Array(await readFile(wasmFile)));
}

/** Starts a worker in this thread around `core`. */
export function spawnAround(core: Core): Spawn {
  return (listener): PoolWorker => {
    const { port1, port2 } = new MessageChannel();
    expose(new ClipWorker(Promise.resolve(core)), port1);
    port1.start();
    const api = wrap<WorkerApi>(port2) as unknown as RemoteWorker;
    port2.start();
    void api.listen(proxy(listener));
    return {
      api,
      terminate: () => {
        port1.close();
        port2.close();
      },
    };
  };
}
