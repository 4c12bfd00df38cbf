/** One reading of a long file by three.js, on a thread that can be ended: bytes go in, milliseconds come out. */

/** A reading that takes longer, in ms, is ended. */
const LIMIT_MS = 150_000;

export interface ThreeOnce {
  /** What it took; the limit where it was ended. */
  readonly ms: number;
  readonly isEnded: boolean;
}

export function readOnceByThree(bytes: Uint8Array<ArrayBuffer>): Promise<ThreeOnce> {
  const thread = new Worker(new URL('./three-thread.ts', import.meta.url), { type: 'module' });
  return new Promise<ThreeOnce>((resolve, reject) => {
    thread.addEventListener('message', ({ data }: MessageEvent<number>) =>
      resolve({ ms: data, isEnded: false }),
    );
    thread.addEventListener('error', ({ message }) => reject(new Error(message)));
    setTimeout(() => resolve({ ms: LIMIT_MS, isEnded: true }), LIMIT_MS);
    thread.postMessage(bytes);
  }).finally(() => thread.terminate());
}
