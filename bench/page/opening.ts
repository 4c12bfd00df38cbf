/** Opening as the app does: a file on disk goes in, keyposes and the first pose come out of a worker. */
import { createBrowserEngine } from '../../web/src/engine/browser-engine';
import { fileNamed } from './files';

export interface Opened {
  readonly openedMs: number[];
  readonly longestTaskMs: number;
}

/** The longest task of this thread from now on, as the browser reports it (those over 50 ms). */
function watchLongTasks(): () => number {
  let longestMs = 0;
  const observer = new PerformanceObserver((list) => {
    for (const { duration } of list.getEntries()) longestMs = Math.max(longestMs, duration);
  });
  observer.observe({ type: 'longtask' });
  return () => {
    observer.disconnect();
    return longestMs;
  };
}

/** Opens a file several times with fresh ids; the first time includes the start of the workers. */
export async function open(name: string, runs: number): Promise<Opened> {
  const longestTask = watchLongTasks();
  const openedMs: number[] = [];
  const start = performance.now();
  const engine = createBrowserEngine('');
  for (let run = 0, from = start; run < runs; run += 1, from = performance.now()) {
    await engine.open(run, { name, folder: '', blob: fileNamed(name) }, {}, {});
    await engine.poseRange(run, 0, 0, 1);
    openedMs.push(performance.now() - from);
    engine.close(run);
  }
  engine.destroy();
  return { openedMs, longestTaskMs: longestTask() };
}
