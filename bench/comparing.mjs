// A set compared. In: a set of motions on the disk. Out: how long the command and the app take until all of it is
// compared, and what memory; in the app also the first picture and the longest task.
import { spawn } from 'node:child_process';
import { join } from 'node:path';
import { inApp } from './app.mjs';
import { releaseFolder } from './files.mjs';
import { peakBytesOf } from './memory.mjs';

const command = join(releaseFolder, process.platform === 'win32' ? 'keypose.exe' : 'keypose');

/** How often the command's memory is looked at: its peak only grows. */
const LOOK_MS = 20;

/** Nothing more is compared once the app has not told of it for so long. */
const QUIET_MS = 3_000;

/** `keypose compare DIR`: seconds, and bytes at the peak. */
export function compareNatively({ folder }, threads) {
  const args = ['compare', folder, '--json', '--threads', String(threads)];
  const start = performance.now();
  const child = spawn(command, args, { stdio: ['ignore', 'ignore', 'inherit'] });
  let memoryBytes = null;
  const looking = setInterval(() => (memoryBytes = peakBytesOf(child.pid) ?? memoryBytes), LOOK_MS);
  return new Promise((resolve, reject) => {
    child.on('error', reject);
    child.on('exit', (status) => {
      clearInterval(looking);
      const seconds = (performance.now() - start) / 1e3;
      if (status === 0) resolve({ threads, seconds, memoryBytes });
      else reject(new Error(`keypose ${args.join(' ')} failed`));
    });
  });
}

/** The set dropped at once on the app, the page of comparison open. */
export function compareInApp(address, { folder }, workers) {
  return inApp(address, `?stage=off&workers=${workers}`, async (app) => {
    const startTaskMs = await app.takeLongestTask();
    await app.drop(folder);
    await app.page.locator('.top-bar').getByText('Compare', { exact: true }).click();
    await app.until((ms) => {
      const { comparedMs, firstPictureMs } = window.probe;
      return comparedMs > 0 && firstPictureMs > 0 && performance.now() - comparedMs > ms;
    }, QUIET_MS);
    const { droppedMs, firstPictureMs, comparedMs, longestTaskMs } = await app.probe();
    return {
      workers,
      firstPictureMs: firstPictureMs - droppedMs,
      comparedMs: comparedMs - droppedMs,
      startTaskMs,
      longestTaskMs,
      memoryBytes: app.memory.peakBytes(),
    };
  });
}
