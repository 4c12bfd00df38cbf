/** three.js on a thread of its own: bytes of a file come in, the milliseconds of its one reading go out. */
import { readByThree } from './readers';

addEventListener('message', ({ data }: MessageEvent<Uint8Array<ArrayBuffer>>) => {
  const start = performance.now();
  readByThree(data);
  postMessage(performance.now() - start);
});
